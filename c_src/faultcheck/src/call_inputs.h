// What the triggers of a call ask of the world outside: the time and the user's predicates. It is
// gathered without any lock held, then the call is made under the lock.
#pragma once

#include "clock.h"
#include "fault.h"

namespace fc {

// True when the fault cannot do without inputs.
inline bool wants_time(const Trigger &trigger, const Model &model) {
    return (trigger.conditions & Trigger::kTime) != 0 || model.kind == FC_DRIFT_TIMED ||
           model.kind == FC_HELD_OFFSET;
}
inline bool wants_predicate(const Trigger &trigger) {
    return (trigger.conditions & Trigger::kWhen) != 0;
}

class InputGatherer {
  public:
    const CallInputs &inputs() const {
        return inputs_;
    }

    // Under the lock: what the faults ask for.
    void want_time() {
        time_wanted_ = time_wanted_ || !inputs_.has_time;
    }
    void want(const Trigger &trigger) {
        if (inputs_.find(trigger.predicate, trigger.user) == nullptr)
            asked_.push_back({trigger.predicate, trigger.user, false});
    }
    void want(const Trigger &trigger, const Model &model) {
        if (wants_time(trigger, model))
            want_time();
        if (wants_predicate(trigger))
            want(trigger);
    }
    bool complete() const {
        return !time_wanted_ && asked_.empty();
    }

    // Without any lock held.
    void gather(const Clock &clock) {
        if (time_wanted_) {
            inputs_.now = clock.now();
            inputs_.has_time = true;
            time_wanted_ = false;
        }
        for (CallInputs::Verdict &verdict : asked_) {
            if (inputs_.find(verdict.predicate, verdict.user) != nullptr)
                continue;
            verdict.holds = verdict.predicate(verdict.user);
            verdicts_.push_back(verdict);
            inputs_.verdicts = verdicts_.data();
            inputs_.count = verdicts_.size();
        }
        asked_.clear();
    }

  private:
    CallInputs inputs_;
    std::vector<CallInputs::Verdict> verdicts_;
    std::vector<CallInputs::Verdict> asked_;
    bool time_wanted_ = false;
};

} // namespace fc
