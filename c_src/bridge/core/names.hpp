// Atoms that the core reads or writes often.
#pragma once

#include "term.hpp"

namespace cb::names {

inline const Name null{"null"};
inline const Name ptr{"ptr"};
inline const Name true_{"true"};
inline const Name false_{"false"};
inline const Name nan{"nan"};
inline const Name inf{"inf"};
inline const Name neg_inf{"neg_inf"};
inline const Name ok{"ok"};

} // namespace cb::names
