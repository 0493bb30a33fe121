/* coptersim_wrapper.h: the names of the original simulator, for programs written for it.
 *
 * All functions act on csim_default(), whose faults are those of fc_default(), so that
 * faultcheck_wrapper.h and faultcheck_packet_wrapper.h act on it. Ids beyond 2^31-1 and values that
 * are not finite are ignored; csim_last_error_text tells why. */
#ifndef COPTERSIM_WRAPPER_H
#define COPTERSIM_WRAPPER_H

#include "csim.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A place; pz is always 0. */
typedef struct {
    double px, py, pz; /* m, world */
} POINT_t;

/* The pilot's command. */
typedef struct {
    double rollCmd, pitchCmd, yawCmd; /* -1..1 */
    double throttleCmd;               /* 0..1 */
} CONTROL_INPUT_t;

/* At rest and level at (px, py), in m, heading along +x. */
CSIM_API void coptersim_addCopter(double px, double py, unsigned int id);
/* Take a copter out of the world; what others have heard of it they keep for a while. */
CSIM_API void coptersim_removeCopter(unsigned int id);
/* Take all copters out. */
CSIM_API void coptersim_removeAllCopters(void);
/* Run steps of dt_us microseconds; messages every its_div steps, an anchor every anchor_div. */
CSIM_API void coptersim_runIterations(unsigned long iterations, unsigned long dt_us, int its_div,
                                      int anchor_div);
/* The pilot's command from now on. 1, or 0 when there is no such copter or a value is NaN. */
CSIM_API int coptersim_setControlInput(unsigned int id, CONTROL_INPUT_t input);
/* For a viewer: without effect. */
CSIM_API void coptersim_selectCopter(unsigned int id);
/* Call the function given to coptersim_onSendState; without one nothing. */
CSIM_API void coptersim_sendStateToMap(void);
/* What coptersim_sendStateToMap calls; NULL: nothing. */
CSIM_API void coptersim_onSendState(void (*send)(void *user, csim *sim), void *user);
/* 1 after a collision, else 0. */
CSIM_API int coptersim_collisionOccured(void);
/* Of the first collision; (0, 0, 0) when there is none. */
CSIM_API POINT_t coptersim_collisionPoint(void);
/* Forget the collisions, so that runs go on. */
CSIM_API void coptersim_resetCollision(void);
/* End the run after the step under way; coptersim_resetCollision lets runs go on. */
CSIM_API void coptersim_stopSimulation(void);
/* A wall from (x1, y1) to (x2, y2), in m. */
CSIM_API void coptersim_addLineSegment(unsigned int id, double x1, double y1, double x2, double y2);
/* Take all walls out. */
CSIM_API void coptersim_removeAllLineSegments(void);
/* Something to measure distances to, at (x, y, z), in m. */
CSIM_API void coptersim_addAnchor(unsigned int id, double x, double y, double z);
/* Take all anchors out. */
CSIM_API void coptersim_removeAllAnchors(void);

#ifdef __cplusplus
}
#endif

#endif
