// The names of the original simulator, on the default simulation.
#include "coptersim_wrapper.h"

#include "failure.h"

namespace {

// Without an id the call that follows fails, and says why.
int32_t id_of(unsigned int id) {
    return id <= INT32_MAX ? static_cast<int32_t>(id) : -1;
}

struct Stream {
    void (*send)(void *user, csim *sim);
    void *user;
};
Stream stream;

} // namespace

extern "C" {

void coptersim_addCopter(double px, double py, unsigned int id) {
    csim_add_copter(csim_default(), id_of(id), px, py, 0);
}

void coptersim_removeCopter(unsigned int id) {
    csim_remove_copter(csim_default(), id_of(id));
}

void coptersim_removeAllCopters(void) {
    csim_clear_copters(csim_default());
}

void coptersim_runIterations(unsigned long iterations, unsigned long dt_us, int its_div,
                             int anchor_div) {
    csim_run(csim_default(), iterations, dt_us, its_div, anchor_div);
}

int coptersim_setControlInput(unsigned int id, CONTROL_INPUT_t input) {
    return csim_command(csim_default(), id_of(id), input.rollCmd, input.pitchCmd, input.yawCmd,
                        input.throttleCmd) == CSIM_OK;
}

void coptersim_selectCopter(unsigned int id) {
    (void)id;
}

void coptersim_sendStateToMap(void) {
    if (stream.send != nullptr)
        stream.send(stream.user, csim_default());
}

void coptersim_onSendState(void (*send)(void *user, csim *sim), void *user) {
    stream = {send, user};
}

int coptersim_collisionOccured(void) {
    size_t count = 0;
    csim_collisions(csim_default(), nullptr, &count);
    return count > 0;
}

POINT_t coptersim_collisionPoint(void) {
    csim_collision first;
    size_t count = 1;
    csim_collisions(csim_default(), &first, &count);
    return count > 0 ? POINT_t{first.x, first.y, 0} : POINT_t{0, 0, 0};
}

void coptersim_resetCollision(void) {
    csim_resume(csim_default());
}

void coptersim_stopSimulation(void) {
    csim_stop(csim_default());
}

void coptersim_addLineSegment(unsigned int id, double x1, double y1, double x2, double y2) {
    csim_add_line(csim_default(), id_of(id), x1, y1, x2, y2);
}

void coptersim_removeAllLineSegments(void) {
    csim_clear_lines(csim_default());
}

void coptersim_addAnchor(unsigned int id, double x, double y, double z) {
    csim_add_anchor(csim_default(), id_of(id), x, y, z);
}

void coptersim_removeAllAnchors(void) {
    csim_clear_anchors(csim_default());
}

} // extern "C"
