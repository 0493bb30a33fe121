/* teller.hpp: tells one sink what there is to see of a scenario that is played, each kind of
 * message in its own interval of simulated time. */
#ifndef CSIM_STREAM_TELLER_HPP
#define CSIM_STREAM_TELLER_HPP

#include "sink.hpp"
#include "story.hpp"

#include <map>

namespace coptersim_stream {

/* What all messages of a run have in common. */
struct telling {
    std::int32_t run = 1;
    std::int32_t observer = -1;
    double speed = 1;                /* simulated seconds per second, as told */
    std::uint64_t pace_us = 1000000; /* simulated time for what is told once a second */
    std::uint64_t frame_us = 20000;  /* between frames, whole steps */
};

/* As many whole steps as fit into 20 ms times the speed, at least one. */
std::uint64_t frame_interval(std::uint64_t dt_us, double speed);

class teller {
  public:
    teller(const csim *sim, const csim_scenario::scenario &s, const telling &how, sink &to);

    /* When it has something to tell if nothing happens before. */
    std::uint64_t next_us() const {
        return next_us_;
    }
    /* Everything that is due now; `happened` and the end of the run are told at once. false: error
     * is one line. */
    bool tell(story &s, const std::vector<viz::event> &happened, std::string &error);

  private:
    bool due(const char *channel, std::uint64_t per_second);
    template <class M> bool put(const char *channel, const M &message, std::string &error);
    bool tell_lasting(story &s, std::string &error);
    bool tell_moment(story &s, std::string &error);
    bool tell_status(story &s, std::string &error);

    const csim *sim_;
    const csim_scenario::scenario &scenario_;
    telling how_;
    sink &to_;
    std::uint64_t next_us_ = 0;
    std::int32_t frames_ = 0;
    std::map<std::string, std::uint64_t> told_us_;
    std::map<std::int32_t, std::int32_t> line_places_;
    std::vector<std::pair<std::int64_t, bool>> fault_key_;
    verdict verdict_ = verdict_running;
};

} // namespace coptersim_stream

#endif
