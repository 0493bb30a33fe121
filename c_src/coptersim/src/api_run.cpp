// Running, collisions, closeness and messages of csim.h.
#include "api.h"
#include "step.h"

using namespace coptersim;

namespace {

constexpr std::uint64_t kLongestStep = 1000000000; // us

int check_run(const csim *sim, std::uint64_t dt_us) {
    if (sim == nullptr)
        return fail_null("csim_run", "sim");
    if (sim->running)
        return fail(CSIM_E_ARG, "csim_run: called from the function given to csim_on_step");
    if (dt_us < 1 || dt_us > kLongestStep)
        return fail(CSIM_E_ARG, "csim_run: dt_us %llu is outside 1..%llu",
                    static_cast<unsigned long long>(dt_us),
                    static_cast<unsigned long long>(kLongestStep));
    if (sim->world.status != CSIM_RUNNING)
        return fail(CSIM_E_HALTED, "csim_run: %s, csim_resume or csim_reset first",
                    sim->world.status == CSIM_COLLIDED ? "a collision ended the run" : "stopped");
    return CSIM_OK;
}

// Marks the simulation as running while it is there.
class Running {
  public:
    explicit Running(csim *sim) : sim_(sim) {
        sim_->running = true;
    }
    ~Running() {
        sim_->running = false;
    }
    Running(const Running &) = delete;
    Running &operator=(const Running &) = delete;

  private:
    csim *sim_;
};

// What happens between steps: the function of csim_on_step may change anything.
void after_step(csim *sim, StepPlan *plan, int its_div, int anchor_div) {
    if (sim->on_step == nullptr)
        return;
    if (sim->on_step(sim->step_user, sim) != 0)
        csim_stop(sim);
    sim->prepare();
    *plan = make_plan(sim->world.params, plan->dt_us, its_div, anchor_div);
}

} // namespace

extern "C" {

int csim_run(csim *sim, uint64_t steps, uint64_t dt_us, int its_div, int anchor_div) {
    if (const int code = check_run(sim, dt_us))
        return code;
    return guarded("csim_run", [&] {
        const Running running(sim);
        sim->prepare();
        StepPlan plan = make_plan(sim->world.params, dt_us, its_div, anchor_div);
        for (; steps > 0 && sim->world.status == CSIM_RUNNING; --steps) {
            run_step(*sim, plan);
            after_step(sim, &plan, its_div, anchor_div);
        }
        return CSIM_OK;
    });
}

uint64_t csim_time(const csim *sim) {
    return sim != nullptr ? sim->world.time_us : 0;
}

csim_run_state csim_status(const csim *sim) {
    return sim != nullptr ? sim->world.status : CSIM_STOPPED;
}

int csim_stop(csim *sim) {
    if (sim == nullptr)
        return fail_null("csim_stop", "sim");
    if (sim->world.status == CSIM_RUNNING)
        sim->world.status = CSIM_STOPPED;
    return CSIM_OK;
}

int csim_resume(csim *sim) {
    if (sim == nullptr)
        return fail_null("csim_resume", "sim");
    sim->world.status = CSIM_RUNNING;
    sim->world.collisions.forget();
    return CSIM_OK;
}

int csim_collisions(const csim *sim, csim_collision *list, size_t *count) {
    if (sim == nullptr || count == nullptr)
        return fail_null("csim_collisions", sim == nullptr ? "sim" : "count");
    return copy_out(sim->world.collisions.recorded(), list, count, "csim_collisions");
}

int csim_on_step(csim *sim, csim_step_fn step, void *user) {
    if (sim == nullptr)
        return fail_null("csim_on_step", "sim");
    sim->on_step = step;
    sim->step_user = user;
    return CSIM_OK;
}

int csim_watch_closeness(csim *sim, csim_closeness_kind kind, uint64_t horizon_us) {
    if (sim == nullptr)
        return fail_null("csim_watch_closeness", "sim");
    if (kind < CSIM_GAP || kind > CSIM_LATE || horizon_us == 0)
        return fail(CSIM_E_ARG, "csim_watch_closeness: unknown kind, or a horizon of 0");
    sim->world.closeness.watch(kind, horizon_us);
    return CSIM_OK;
}

int csim_closest(const csim *sim, csim_closeness *closest) {
    if (sim == nullptr || closest == nullptr)
        return fail_null("csim_closest", sim == nullptr ? "sim" : "closest");
    if (!sim->world.closeness.watching())
        return fail(CSIM_E_ARG, "csim_closest: csim_watch_closeness has not been called");
    *closest = sim->world.closeness.closest();
    return CSIM_OK;
}

int csim_pack(const csim_message *message, uint8_t bytes[CSIM_MESSAGE_BYTES]) {
    if (message == nullptr || bytes == nullptr)
        return fail_null("csim_pack", message == nullptr ? "message" : "bytes");
    pack(*message, bytes);
    return CSIM_OK;
}

int csim_unpack(const uint8_t *bytes, size_t len, csim_message *message) {
    if (bytes == nullptr || message == nullptr)
        return fail_null("csim_unpack", bytes == nullptr ? "bytes" : "message");
    if (len != CSIM_MESSAGE_BYTES)
        return fail(CSIM_E_ARG, "csim_unpack: %zu bytes, a message has %d", len,
                    static_cast<int>(CSIM_MESSAGE_BYTES));
    *message = unpack(bytes);
    return CSIM_OK;
}

} // extern "C"
