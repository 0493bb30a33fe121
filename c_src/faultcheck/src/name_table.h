// Finds the record of an identifier without a lock, while another thread may be adding records.
//
// Records are never removed before the table itself, so a pointer found stays good. A table that
// has become too small is replaced by one of twice the size and kept until the end: a reader may
// still be in it. Together the old ones are smaller than the current one.
#pragma once

#include "name.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace fc {

template <class Record> class NameTable {
  public:
    NameTable() {
        publish(std::make_unique<Table>(kFirstSize));
    }

    // Any thread.
    Record *find(const Name &name) const {
        const Table *table = current_.load(std::memory_order_acquire);
        for (std::size_t at = name.hash & table->mask;; at = (at + 1) & table->mask) {
            const Slot &slot = table->slots[at];
            Record *record = slot.record.load(std::memory_order_acquire);
            if (record == nullptr)
                return nullptr;
            if (slot.hash == name.hash && record->name.equals(name))
                return record;
        }
    }

    // Under the owner's lock. The name must not be present. Throws std::bad_alloc with nothing
    // changed.
    Record &add(const Name &name) {
        auto record = std::make_unique<Record>(name);
        if (records_.size() == records_.capacity())
            records_.reserve(2 * records_.size() + 1);
        if (2 * (records_.size() + 1) > current_.load(std::memory_order_relaxed)->mask)
            grow();
        insert(*tables_.back(), record.get());
        records_.push_back(std::move(record));
        return *records_.back();
    }

    // Under the owner's lock.
    const std::vector<std::unique_ptr<Record>> &all() const {
        return records_;
    }

  private:
    static constexpr std::size_t kFirstSize = 64;

    struct Slot {
        std::uint64_t hash = 0;
        std::atomic<Record *> record{nullptr};
    };

    struct Table {
        explicit Table(std::size_t size) : mask(size - 1), slots(new Slot[size]) {}
        std::size_t mask;
        std::unique_ptr<Slot[]> slots;
    };

    void grow() {
        auto next = std::make_unique<Table>(2 * (tables_.back()->mask + 1));
        for (const auto &record : records_)
            insert(*next, record.get());
        publish(std::move(next));
    }

    static void insert(Table &table, Record *record) {
        const std::uint64_t hash = record->name.hash();
        std::size_t at = hash & table.mask;
        while (table.slots[at].record.load(std::memory_order_relaxed) != nullptr)
            at = (at + 1) & table.mask;
        table.slots[at].hash = hash;
        table.slots[at].record.store(record, std::memory_order_release);
    }

    void publish(std::unique_ptr<Table> table) {
        tables_.push_back(std::move(table));
        current_.store(tables_.back().get(), std::memory_order_release);
    }

    std::atomic<const Table *> current_{nullptr};
    std::vector<std::unique_ptr<Table>> tables_;
    std::vector<std::unique_ptr<Record>> records_;
};

} // namespace fc
