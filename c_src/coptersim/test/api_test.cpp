// Every function of csim.h refuses what it cannot do, says why, and changes nothing.
#include "check.h"
#include "coptersim_wrapper.h"
#include "csim.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

bool says(const char *text) {
    return std::strstr(csim_last_error_text(), text) != nullptr;
}

void options_are_checked() {
    csim_options options = CSIM_OPTIONS_INIT;
    options.size = 3;
    CHECK(csim_new(&options) == nullptr && says("size"));
    options = CSIM_OPTIONS_INIT;
    options.threads = 65;
    CHECK(csim_new(&options) == nullptr && says("1..64"));
    options = CSIM_OPTIONS_INIT;
    options.build = "z80";
    CHECK(csim_new(&options) == nullptr && says("z80"));
    csim_free(nullptr);
    CHECK(csim_build_at(0) != nullptr && csim_build_at(-1) == nullptr);
    CHECK(csim_build_at(99) == nullptr);
}

void things_are_checked(csim *sim) {
    CHECK_INT(csim_add_copter(nullptr, 0, 0, 0, 0), CSIM_E_ARG);
    CHECK_INT(csim_add_copter(sim, -1, 0, 0, 0), CSIM_E_ARG);
    CHECK_INT(csim_add_copter(sim, 1, kNan, 0, 0), CSIM_E_ARG);
    CHECK_INT(csim_add_copter(sim, 1, 0, 1e10, 0), CSIM_E_ARG);
    CHECK_INT(csim_add_copter(sim, 1, 0, 0, kInf), CSIM_E_ARG);
    CHECK_INT(csim_count(sim), 0);
    CHECK_INT(csim_add_line(sim, 1, 0, 0, kInf, 0), CSIM_E_ARG);
    CHECK_INT(csim_add_anchor(sim, -5, 0, 0, 0), CSIM_E_ARG);
    CHECK_INT(csim_remove_copter(sim, 1), CSIM_E_ID);
    CHECK(says("copter 1"));
    CHECK_INT(csim_command(sim, 1, 0, 0, 0, 0), CSIM_E_ID);
    csim_state state{};
    CHECK_INT(csim_get_state(sim, 1, CSIM_TRUE, &state), CSIM_E_ID);
    csim_add_copter(sim, 1, 0, 0, 0);
    CHECK_INT(csim_command(sim, 1, kNan, 0, 0, 0), CSIM_E_ARG);
    CHECK_INT(csim_get_state(sim, 1, CSIM_TRUE, nullptr), CSIM_E_ARG);
    state.vx = kInf;
    CHECK_INT(csim_set_state(sim, 1, CSIM_TRUE, &state), CSIM_E_ARG);
    CHECK_INT(csim_override(sim, 1, nullptr), CSIM_E_ARG);
    CHECK_INT(csim_override(sim, 2, nullptr), CSIM_E_ID);
    csim_gains gains;
    CHECK_INT(csim_get_gains(sim, 1, &gains), CSIM_OK);
    gains.vel_p = -1;
    CHECK_INT(csim_set_gains(sim, 1, &gains), CSIM_E_ARG);
    CHECK(says("vel_p"));
    CHECK_INT(csim_set_gains_all(sim, &gains), CSIM_E_ARG);
    CHECK_INT(csim_set_gains(sim, 7, &gains), CSIM_E_ID);
}

void parameters_are_checked(csim *sim) {
    double value = 0;
    CHECK_INT(csim_set(sim, "comfort", 1), CSIM_E_NAME);
    CHECK_INT(csim_set(sim, "comfort_radius", -1), CSIM_E_ARG);
    CHECK_INT(csim_set(sim, "comfort_radius", kNan), CSIM_E_ARG);
    CHECK_INT(csim_set(sim, "gate", 1.5), CSIM_E_ARG);
    CHECK_INT(csim_get(sim, "gate", nullptr), CSIM_E_ARG);
    CHECK_INT(csim_set_text(sim, "gate", "open"), CSIM_E_ARG);
    CHECK_INT(csim_set_text(sim, "gate", "median"), CSIM_OK);
    CHECK_INT(csim_get(sim, "gate", &value), CSIM_OK);
    CHECK_BITS(value, 1);
    CHECK_INT(csim_set_text(sim, "halt_on_collision", "false"), CSIM_OK);
    CHECK_INT(csim_set_text(sim, "vel_p", "1.25"), CSIM_OK);
    csim_gains gains;
    csim_get_gains(sim, 1, &gains);
    CHECK_BITS(gains.vel_p, 1.25);
    CHECK_INT(csim_set_text(sim, "vel_p", "1.25x"), CSIM_E_ARG);
    CHECK_INT(csim_configure(sim, "soft"), CSIM_E_NAME);
    CHECK_INT(csim_configure(sim, "hardened"), CSIM_OK);
    CHECK_INT(csim_configure(sim, "default"), CSIM_OK);
    for (int i = 0; i < csim_param_count(); i++) {
        const csim_param *param = csim_param_at(i);
        csim_get(sim, param->name, &value);
        CHECK_BITS(value, param->initial);
        CHECK(value >= param->min && value <= param->max);
    }
    CHECK(csim_param_at(-1) == nullptr && csim_param_at(csim_param_count()) == nullptr);
}

int try_to_run(void *result, csim *sim) {
    *static_cast<int *>(result) = csim_run(sim, 1, 5000, 20, 20);
    return 1;
}

void runs_are_checked(csim *sim) {
    CHECK_INT(csim_run(nullptr, 1, 5000, 20, 20), CSIM_E_ARG);
    CHECK_INT(csim_run(sim, 1, 0, 20, 20), CSIM_E_ARG);
    CHECK_INT(csim_run(sim, 1, 1000000001, 20, 20), CSIM_E_ARG);
    CHECK_INT(csim_run(sim, 0, 5000, -3, -3), CSIM_OK);
    CHECK_INT(csim_time(sim), 0);
    int inner = CSIM_OK;
    csim_on_step(sim, try_to_run, &inner);
    CHECK_INT(csim_run(sim, 10, 5000, 20, 20), CSIM_OK);
    CHECK_INT(inner, CSIM_E_ARG);
    CHECK_INT(csim_time(sim), 5000);
    CHECK_INT(csim_status(sim), CSIM_STOPPED);
    CHECK_INT(csim_run(sim, 1, 5000, 20, 20), CSIM_E_HALTED);
    csim_on_step(sim, nullptr, nullptr);
    CHECK_INT(csim_resume(sim), CSIM_OK);
    CHECK_INT(csim_run(sim, 1, 5000, 20, 20), CSIM_OK);
    csim_closeness closest;
    CHECK_INT(csim_closest(sim, &closest), CSIM_E_ARG);
    CHECK_INT(csim_watch_closeness(sim, CSIM_GAP, 0), CSIM_E_ARG);
    CHECK_INT(csim_watch_closeness(sim, CSIM_GAP, 1), CSIM_OK);
    CHECK_INT(csim_closest(sim, &closest), CSIM_OK);
    CHECK(closest.value == kInf);
}

void room_is_checked(csim *sim) {
    csim_ldm_entry entries[1];
    csim_add_line(sim, 4, 0, 3, 3, 3);
    size_t count = 1;
    CHECK_INT(csim_ldm(sim, 1, entries, &count), CSIM_E_SPACE);
    CHECK_INT(count, 2);
    CHECK_INT(csim_ldm(sim, 99, entries, &count), CSIM_E_ID);
    csim_collision hit;
    csim_add_copter(sim, 2, 0.1, 0, 0);
    csim_add_copter(sim, 3, 0, 0.1, 0);
    csim_run(sim, 1, 5000, 20, 20);
    count = 1;
    CHECK_INT(csim_collisions(sim, &hit, &count), CSIM_E_SPACE);
    CHECK_INT(count, 3);
    CHECK(hit.kind == CSIM_COPTER && hit.id == 1 && hit.other == 2);
    CHECK_INT(csim_collisions(sim, nullptr, &count), CSIM_OK);
    uint8_t bytes[CSIM_MESSAGE_BYTES] = {0};
    csim_message message;
    CHECK_INT(csim_unpack(bytes, 91, &message), CSIM_E_ARG);
    CHECK_INT(csim_unpack(nullptr, 92, &message), CSIM_E_ARG);
    CHECK_INT(csim_pack(nullptr, bytes), CSIM_E_ARG);
}

// Byte positions of section 7 of docs/coptersim.md; 1.0 is 0x3ff0000000000000.
void messages_have_their_layout() {
    csim_message message{0x01020304, 0x1122334455667788, {}}, back;
    message.state.vx = 1;
    message.state.yaw = -2;
    uint8_t bytes[CSIM_MESSAGE_BYTES];
    CHECK_INT(csim_pack(&message, bytes), CSIM_OK);
    CHECK(bytes[0] == 4 && bytes[3] == 1 && bytes[4] == 0x88 && bytes[11] == 0x11);
    CHECK(bytes[42] == 0xf0 && bytes[43] == 0x3f && bytes[91] == 0xc0);
    CHECK_INT(csim_unpack(bytes, sizeof bytes, &back), CSIM_OK);
    CHECK(back.id == message.id && back.stamp_us == message.stamp_us && back.state.yaw == -2);
}

void snapshots_know_their_simulation(csim *sim) {
    csim *other = csim_new(nullptr);
    csim_snapshot *snapshot = csim_save(sim);
    CHECK(snapshot != nullptr);
    CHECK_INT(csim_restore(other, snapshot), CSIM_E_SNAPSHOT);
    CHECK_INT(csim_restore(sim, nullptr), CSIM_E_ARG);
    CHECK_INT(csim_restore(sim, snapshot), CSIM_OK);
    csim_release(snapshot);
    csim_release(nullptr);
    csim_free(other);
    CHECK(csim_save(csim_default()) == nullptr && says("someone else"));
}

void the_names_of_the_original_work() {
    coptersim_addCopter(0, 0, 5);
    coptersim_addCopter(0, 0, 4000000000u);
    CHECK_INT(csim_count(csim_default()), 1);
    CHECK_INT(coptersim_setControlInput(5, CONTROL_INPUT_t{0.1, 0, 0, 0}), 1);
    CHECK_INT(coptersim_setControlInput(6, CONTROL_INPUT_t{0.1, 0, 0, 0}), 0);
    coptersim_addAnchor(0, 1, 1, 1);
    coptersim_addLineSegment(1, 0.2, -1, 0.2, 1);
    coptersim_runIterations(10, 5000, 20, 20);
    CHECK_INT(coptersim_collisionOccured(), 1);
    CHECK_BITS(coptersim_collisionPoint().px, 0.2);
    CHECK_INT(csim_time(csim_default()), 5000);
    coptersim_resetCollision();
    CHECK_INT(coptersim_collisionOccured(), 0);
    coptersim_stopSimulation();
    coptersim_removeAllLineSegments();
    coptersim_removeAllAnchors();
    coptersim_removeCopter(5);
    coptersim_removeAllCopters();
    coptersim_sendStateToMap();
    CHECK_INT(csim_count(csim_default()), 0);
    csim_free(csim_default()); // left alone
    CHECK_INT(csim_reset(csim_default()), CSIM_OK);
}

} // namespace

int main() {
    options_are_checked();
    csim *sim = csim_new(nullptr);
    things_are_checked(sim);
    parameters_are_checked(sim);
    runs_are_checked(sim);
    room_is_checked(sim);
    messages_have_their_layout();
    snapshots_know_their_simulation(sim);
    csim_free(sim);
    the_names_of_the_original_work();
    CHECK(std::strcmp(csim_error_name(CSIM_E_SPACE), "CSIM_E_SPACE") == 0);
    CHECK(std::strcmp(csim_error_name(5), "CSIM_E_UNKNOWN") == 0);
    return CHECK_RESULT();
}
