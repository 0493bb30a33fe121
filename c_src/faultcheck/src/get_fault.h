// The faults met at a get, one by one.
#pragma once

#include "transit.h"

namespace fc {

// What a fault that has been triggered works with.
struct GetFault {
    ChannelFault &fault;
    FaultRun &run;
    const GetCall &call;
    const Receiver &receiver;
};

// True for a fault that can do something although there is no packet to deliver.
bool works_without_packet(ChannelModelKind kind);

// The channel a MASQUERADE takes packets of, or null when there is none of that name.
Channel *masquerade_source(fc_context &context, const ChannelModel &model);

// FC_OK, or why the fault was skipped.
int apply_at_get(const GetFault &fault, Transit &transit);

} // namespace fc
