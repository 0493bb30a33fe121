// Probes while another thread sends commands: a probe call sees a fault whole or not at all.
#include "check.h"
#include "fi.h"

#include <atomic>
#include <thread>

namespace {

constexpr int kRounds = 5000;

// Each fault replaces a value by one that names it; a mixture of two would give another one. The
// identifiers share a slot: each is cleared before the next is added.
void commands(std::atomic<bool> &done) {
    for (int round = 0; round < kRounds; ++round) {
        fi_process_line("fi_add_fault first SET_TO 1000 0 0", nullptr);
        fi_process_line("fi_add_fault first OFFSET 1 0 0", nullptr);
        fi_process_line("fi_reset_cnt", nullptr);
        fi_process_line("fi_clear_faults", nullptr);
        fi_process_line("fi_add_fault second AMPLIFICATION 0 0 0", nullptr);
        fi_process_line("fi_print_faults", nullptr);
        fi_process_line("fi_clear_faults", nullptr);
    }
    done = true;
}

void probing_while_faults_come_and_go() {
    std::atomic<bool> done{false};
    fi_init();
    fi_process_line("fi_set_enabled 1", nullptr);
    std::thread prober([&] {
        while (!done) {
            int first = 7;
            float second = 5;
            fi_inject_fault_int("first", &first);
            CHECK(first == 7 || first == 1000 || first == 1001);
            fi_inject_fault_float("second", &second);
            CHECK(second == 5 || second == 0);
        }
    });
    commands(done);
    prober.join();
}

// Probes of different identifiers do not count each other's calls.
void probes_of_several_threads() {
    fi_init();
    fi_process_line("fi_set_enabled 1", nullptr);
    fi_process_line("fi_add_fault one OFFSET 1 0 1000", nullptr);
    fi_process_line("fi_add_fault two OFFSET 1 500 1000", nullptr);
    int sums[2] = {0, 0};
    const auto probe = [&sums](int which, const char *id) {
        for (int call = 0; call < kRounds; ++call) {
            int value = 0;
            fi_inject_fault_int(id, &value);
            sums[which] += value;
        }
    };
    std::thread one(probe, 0, "one");
    std::thread two(probe, 1, "two");
    one.join();
    two.join();
    CHECK_INT(sums[0], 1000);
    CHECK_INT(sums[1], 1000);
}

} // namespace

int main() {
    probing_while_faults_come_and_go();
    probes_of_several_threads();
    return CHECK_RESULT();
}
