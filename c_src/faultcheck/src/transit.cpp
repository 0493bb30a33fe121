#include "transit.h"

namespace fc {

Transit::Transit(Receiver &receiver, const CallInputs &inputs) : now_(inputs.now) {
    views_.emplace_back(receiver.queue, receiver.gets, now_);
    take_next();
}

void Transit::take_next() {
    present = queue().take(&clean);
    source_ = present ? &queue() : nullptr;
    current = clean;
}

void Transit::choose(const std::string &packet) {
    give_back();
    clean = current = packet;
    present = true;
}

bool Transit::choose_from(PacketQueue &other, std::uint64_t gets) {
    QueueView &view = view_of(other, gets);
    std::string packet;
    if (!view.take(&packet))
        return false;
    choose(packet);
    source_ = &view;
    return true;
}

void Transit::choose_position(std::uint64_t position) {
    give_back();
    std::vector<std::string> passed;
    std::string packet;
    while (passed.size() <= position && queue().take(&packet))
        passed.push_back(packet);
    present = !passed.empty();
    if (!present)
        return;
    clean = current = passed.back();
    source_ = &queue();
    passed.pop_back();
    for (; !passed.empty(); passed.pop_back())
        queue().put_back(passed.back(), 1);
}

void Transit::block() {
    give_back();
    blocked = true;
}

void Transit::reserve_for_commit() {
    for (QueueView &view : views_)
        view.reserve_for_commit();
}

void Transit::commit() noexcept {
    for (QueueView &view : views_)
        view.commit();
}

void Transit::give_back() {
    if (source_ != nullptr)
        source_->put_back(clean, 1);
    source_ = nullptr;
    present = false;
}

QueueView &Transit::view_of(PacketQueue &queue, std::uint64_t gets) {
    for (QueueView &view : views_)
        if (view.is_of(queue))
            return view;
    views_.emplace_back(queue, gets, now_);
    return views_.back();
}

} // namespace fc
