/* main.cpp: coptersim_run. Options and exit status: options.cpp, or coptersim_run --help. */
#include "bisect.hpp"
#include "options.hpp"
#include "output.hpp"
#include "replay.hpp"

#include <csignal>
#include <cstdio>
#include <new>

namespace {

enum exit_status { done = 0, nothing_found = 1, bad_input = 2, collided = 3, stopped = 130 };

volatile std::sig_atomic_t interrupted = 0;

/* The second one ends the program at once. */
void catch_interrupt() {
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

/* The same observer, for a run that stops when interrupted. */
coptersim_run::observer interruptible(coptersim_run::observer o) {
    o.started = [started = std::move(o.started)](csim *sim) {
        csim_on_step(
            sim, [](void *, csim *) -> int { return interrupted; }, nullptr);
        if (started) {
            started(sim);
        }
    };
    return o;
}

int fail(const std::string &reason) {
    std::fprintf(stderr, "coptersim_run: %s\n", reason.c_str());
    return bad_input;
}

bool load(const coptersim_run::options &o, csim_scenario::scenario &s, std::string &error) {
    if (!csim_scenario::read_scenario_file(o.scenario, s, error)) {
        return false;
    }
    for (const std::string &assignment : o.settings) {
        if (!csim_scenario::override_setting(s, assignment, error)) {
            error = "--set " + error;
            return false;
        }
    }
    return true;
}

int run_bisection(const coptersim_run::options &o, const csim_scenario::scenario &s, csim *sim) {
    coptersim_run::bisection found;
    std::string error;
    if (!coptersim_run::bisect(sim, s, *o.bisect, interruptible({}), stdout, found, error)) {
        return fail("--bisect " + error);
    }
    if (interrupted != 0) {
        return stopped;
    }
    const char *name = o.bisect->name.c_str();
    if (!found.smallest) {
        std::printf("every value of %s that was tried from %g to %g has a collision\n", name,
                    o.bisect->low, o.bisect->high);
        return nothing_found;
    }
    std::printf("smallest %s without a collision: %.8g", name, *found.smallest);
    if (found.largest) {
        std::printf(" (collision with %.8g)\n", *found.largest);
    } else {
        std::printf(", the lowest value tried\n");
    }
    return done;
}

int run_trace(const coptersim_run::options &o, const csim_scenario::scenario &s, csim *sim) {
    coptersim_run::replay replay(s, o.part_ms, o.speed, stderr, &interrupted);
    coptersim_run::observer follower =
        interruptible(o.replay ? replay.follower() : coptersim_run::observer{});
    std::string error;
    std::optional<csim_trace::trace> trace = coptersim_run::recorded_run(sim, s, follower, error);
    if (!trace) {
        return fail(error);
    }
    if (interrupted != 0) {
        return stopped;
    }
    if (o.replay) {
        replay.tell_end(*trace);
    }
    if (!coptersim_run::write_trace(*trace, o.csv, o.out, error)) {
        return fail(error);
    }
    return o.fail_on_collision && trace->collision ? collided : done;
}

int run(const coptersim_run::options &o) {
    csim_scenario::scenario s;
    std::string error;
    if (!load(o, s, error)) {
        return fail(error);
    }
    coptersim_run::sim_owner sim =
        coptersim_run::new_simulation(o.threads, o.build.empty() ? nullptr : o.build.c_str());
    if (!sim) {
        return fail(csim_last_error_text());
    }
    catch_interrupt();
    return o.bisect ? run_bisection(o, s, sim.get()) : run_trace(o, s, sim.get());
}

} // namespace

int main(int argc, char **argv) {
    coptersim_run::options o;
    std::string error;
    if (!coptersim_run::parse_options(argc, argv, o, error)) {
        return fail(error);
    }
    if (o.help) {
        std::fputs(coptersim_run::help_text, stdout);
        return done;
    }
    try {
        return run(o);
    } catch (const std::bad_alloc &) {
        return fail("memory is exhausted");
    }
}
