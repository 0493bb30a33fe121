// What a fault on a value does, and whether its parameters make sense.
#pragma once

#include "fc.h"

namespace fc {

using Model = fc_model;

// FC_OK, or FC_E_BIT or FC_E_ARG with the reason in *why.
int check_model(const Model &model, const char **why);

// True when applying it needs memory for values.
inline bool keeps_values(const Model &model) {
    return model.kind == FC_STUCK || model.kind == FC_RAMP || model.kind == FC_DELAY ||
           model.kind == FC_DROPOUT;
}

} // namespace fc
