/* main.cpp: coptersim_stream. Options and exit status: options.cpp, or coptersim_stream --help. */
#include "log_file.hpp"
#include "options.hpp"
#include "publisher.hpp"
#include "recorded_run.hpp"
#include "streamed_run.hpp"

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <new>

using namespace coptersim_stream;

namespace {

enum exit_status { done = 0, bad_input = 2, interrupted_status = 130 };

volatile std::sig_atomic_t interrupted = 0;

/* The second one ends the program at once. */
void catch_interrupt() {
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

int fail(const std::string &reason) {
    std::fprintf(stderr, "coptersim_stream: %s\n", reason.c_str());
    return bad_input;
}

bool load(const options &o, csim_scenario::scenario &s, std::string &error) {
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

/* Waits for simulated times, against the clock at the start, so that waits do not add up. */
class pacer {
  public:
    explicit pacer(double speed) : speed_(speed) {
        clock_gettime(CLOCK_MONOTONIC, &start_);
    }
    void wait(std::uint64_t t_us) const {
        if (!(speed_ > 0)) {
            return;
        }
        double after = 1e-6 * static_cast<double>(t_us) / speed_;
        double whole = std::floor(after);
        timespec deadline = start_;
        deadline.tv_sec += static_cast<time_t>(whole);
        deadline.tv_nsec += static_cast<long>((after - whole) * 1e9);
        if (deadline.tv_nsec >= 1000000000) {
            deadline.tv_sec++;
            deadline.tv_nsec -= 1000000000;
        }
        while (interrupted == 0 &&
               clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
        }
    }

  private:
    double speed_;
    timespec start_;
};

/* What is told to a log is told in simulated time; what is published, in wall time. */
telling how_to_tell(const options &o, const csim_scenario::scenario &s, bool publishing) {
    double speed = publishing && o.speed > 0 ? o.speed : 1;
    telling how;
    how.observer = o.observer ? *o.observer : default_observer(s);
    how.speed = speed;
    how.pace_us = static_cast<std::uint64_t>(1e6 * speed);
    how.frame_us = frame_interval(s.dt_us, speed);
    return how;
}

int stream(const options &o, const csim_scenario::scenario &s, csim *sim) {
    std::string error;
    log_file log;
    publisher network;
    std::vector<listener> listeners;
    if (!o.url.empty()) {
        if (!network.open(o.url, o.allow_network, error)) {
            return fail(error);
        }
        listeners.push_back({&network, how_to_tell(o, s, true)});
    }
    if (!o.log.empty()) {
        if (!log.open(o.log, error)) {
            return fail(error);
        }
        listeners.push_back({&log, how_to_tell(o, s, false)});
    }
    catch_interrupt();
    csim_on_step(
        sim, [](void *, csim *) -> int { return interrupted; }, nullptr);
    pacer clock(o.url.empty() ? 0 : o.speed);
    auto wait = [&](std::uint64_t t_us) {
        clock.wait(t_us);
        if (interrupted != 0) {
            csim_stop(sim);
        }
    };
    outcome result;
    if (!streamed_run(sim, s, listeners, wait, result, error)) {
        return fail(error);
    }
    if (interrupted != 0) {
        return interrupted_status;
    }
    if (!o.log.empty() && !log.finish(error)) {
        return fail(error);
    }
    std::printf("%s: %s\n", s.name.c_str(),
                result.how == verdict_failed ? result.reason.c_str() : "no collision");
    return done;
}

int run(const options &o) {
    csim_scenario::scenario s;
    std::string error;
    if (!load(o, s, error)) {
        return fail(error);
    }
    coptersim_run::sim_owner sim = coptersim_run::new_simulation(1);
    if (!sim) {
        return fail(csim_last_error_text());
    }
    return stream(o, s, sim.get());
}

} // namespace

int main(int argc, char **argv) {
    options o;
    std::string error;
    if (!parse_options(argc, argv, o, error)) {
        return fail(error);
    }
    if (o.help) {
        std::fputs(help_text, stdout);
        return done;
    }
    try {
        return run(o);
    } catch (const std::bad_alloc &) {
        return fail("memory is exhausted");
    }
}
