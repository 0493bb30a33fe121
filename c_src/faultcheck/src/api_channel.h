// Put and get, shared by fc.h, resolved channels and the compatible interface.
#pragma once

#include "context.h"

namespace fc {

// Results and parameters of fc_channel_put and fc_channel_get.
int channel_put(fc_context &context, const char *channel, const char *data, std::size_t len);
int channel_put(fc_context &context, Channel &channel, const char *data, std::size_t len);
int channel_get(fc_context &context, const char *channel, const char *receiver, char *data,
                std::size_t capacity, std::size_t *len);
int channel_get(fc_context &context, Channel &channel, const char *receiver, char *data,
                std::size_t capacity, std::size_t *len);

} // namespace fc
