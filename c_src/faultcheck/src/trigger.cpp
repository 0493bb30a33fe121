#include "trigger.h"

#include "value.h"

namespace fc {

bool Trigger::conditions_hold(const CallInputs &inputs, RandomStream &random) {
    bool hold = true;
    if ((conditions & kPeriodic) != 0)
        hold = passed++ % period < active;
    if ((conditions & kTime) != 0) {
        const Int128 elapsed = static_cast<Int128>(inputs.now) - start;
        hold = hold && elapsed >= delay && (length < 0 || elapsed - delay < length);
    }
    if ((conditions & kWhen) != 0) {
        const CallInputs::Verdict *verdict = inputs.find(predicate, user);
        hold = hold && verdict != nullptr && verdict->holds;
    }
    if ((conditions & kRandom) != 0)
        hold = hold && random.unit() < probability;
    return hold;
}

} // namespace fc
