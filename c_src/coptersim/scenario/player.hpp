/* player.hpp: runs a scenario on a simulation, step by step in simulated time.
 *
 *     csim_scenario::player p(sim, s);
 *     while (p.good() && !p.finished()) {
 *         p.advance(p.time() + 20000);
 *         ...csim_get_state and so on...
 *     }
 *
 * How a run is divided into calls of advance makes no difference to any bit of it. */
#ifndef CSIM_PLAYER_HPP
#define CSIM_PLAYER_HPP

#include "scenario.hpp"

#include <functional>
#include <string>
#include <vector>

namespace csim_scenario {

class player {
  public:
    /* Resets the simulation and sets it up. Both arguments must outlive the player. */
    player(csim *sim, const scenario &s);

    /* False after an error: then error() is one line, and nothing goes on. */
    bool good() const {
        return error_.empty();
    }
    const std::string &error() const {
        return error_;
    }

    std::uint64_t time() const; /* us */
    bool finished() const;      /* good, and at the end, or halted by a collision or a stop */

    /* Steps up to the last end of a step that is not after t_us. Events act before the step that
     * starts at their time, or, between two steps, before the next one. */
    bool advance(std::uint64_t t_us);

    /* Carries out what is ordered for now; advance would do it before its first step. For those who
     * look at the simulation in between. */
    bool act_due();

    /* Called before a copter goes, by a remove_copter event. */
    std::function<void(std::int32_t id)> on_remove;
    /* Called before an event acts. */
    std::function<void(const event &e)> on_event;
    /* Called when the fault of an event has been armed. */
    std::function<void(const event &e, const fault &f, fc_fault_id id)> on_armed;

  private:
    bool check(int status, const char *what);
    void set_up();
    void set_up_copter(const copter &c);
    void act_now();
    std::uint64_t next_change() const;

    void act(const command &c);
    void act(const change_gains &c);
    void act(const change_params &c);
    void act(const fault &f);
    void act(const clear_faults &c);
    void act(const copter &c);
    void act(const remove_copter &r);
    void act(const set_state &s);

    csim *sim_;
    const scenario &scenario_;
    std::string error_;
    csim_gains gains_; /* of copters that say nothing else */
    std::size_t next_event_ = 0;
};

} // namespace csim_scenario

#endif
