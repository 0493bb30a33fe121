/* story.hpp: what happens while a scenario is played, as messages: commands, faults, collisions,
 * how it ends; and what there is to tell before it begins. */
#ifndef CSIM_STREAM_STORY_HPP
#define CSIM_STREAM_STORY_HPP

#include "player.hpp"
#include "viz/case_info.hpp"
#include "viz/event.hpp"
#include "viz/faults.hpp"
#include "viz/world.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace coptersim_stream {

/* As VIZ_STATUS has it. */
enum verdict { verdict_running = 0, verdict_passed = 1, verdict_failed = 2 };

class story {
  public:
    /* Takes the player's functions. All must outlive the story. */
    story(csim *sim, const csim_scenario::scenario &s, csim_scenario::player &player,
          std::int32_t run);
    story(const story &) = delete;
    story &operator=(const story &) = delete;

    /* After steps: collisions, and the end. */
    void look();

    /* What has happened since the last call, in order. */
    std::vector<viz::event> take_events();

    verdict how() const {
        return verdict_;
    }
    /* One line when it has ended badly, "" otherwise. */
    const std::string &reason() const {
        return reason_;
    }

    /* All faults so far, at this moment. */
    viz::faults faults();
    /* Different whenever a fault comes, goes, begins or ends. */
    std::vector<std::pair<std::int64_t, bool>> fault_key() const;
    /* Copters that a fault acts on now. */
    std::set<std::int32_t> faulted() const;

  private:
    struct told_fault {
        fc_fault_id id;
        viz::fault message;
    };

    void on_event(const csim_scenario::event &e);
    void on_armed(const csim_scenario::event &e, const csim_scenario::fault &f, fc_fault_id id);
    void clear(const csim_scenario::clear_faults &c);
    void tell(const char *kind, std::int64_t t_us, std::string text, std::int32_t a = -1,
              std::int32_t b = -1, double x = 0, double y = 0);
    std::map<fc_fault_id, std::uint64_t> applied() const;
    void keep_hits();
    std::int64_t now() const;
    bool acts(const told_fault &f) const;

    csim *sim_;
    const csim_scenario::scenario &scenario_;
    csim_scenario::player &player_;
    std::int32_t run_;
    std::vector<viz::event> events_;
    std::int32_t next_seq_ = 0;
    std::vector<told_fault> faults_;
    std::map<std::int32_t, std::int32_t> line_places_;
    std::size_t collisions_ = 0;
    verdict verdict_ = verdict_running;
    std::string reason_;
};

/* Where each line stands in world.seg, by id. */
std::map<std::int32_t, std::int32_t> line_places(const csim_scenario::scenario &s);
viz::world world_of(const csim_scenario::scenario &s, std::int32_t run);
viz::case_info case_of(const csim_scenario::scenario &s);

/* The copter that a probe or channel belongs to: PxId3, RangeId3Anch0, ITS_DATA3; or -1. */
std::int32_t copter_of(const std::string &probe);

} // namespace coptersim_stream

#endif
