// Faults by name: fc_named.h.
#include "arming.h"
#include "channel_model_table.h"

#include <new>

namespace {

auto models(bool of_channels) {
    return of_channels ? fc::channel_model_at : fc::value_model_at;
}

} // namespace

extern "C" {

const char *fc_model_name(bool of_channels, int index) {
    const fc::NamedModel *model = models(of_channels)(index);
    return model != nullptr ? model->name : nullptr;
}

const fc_parameter *fc_model_parameter(bool of_channels, const char *model, int index) {
    const int known = fc::find_model(models(of_channels), model);
    if (known < 0 || index < 0 || index >= fc::kMostParameters)
        return nullptr;
    const fc_parameter &parameter = models(of_channels)(known)->parameters[index].shown;
    return parameter.name != nullptr ? &parameter : nullptr;
}

fc_fault_id fc_arm_named(fc_context *ctx, const char *id, const char *model,
                         const fc_argument *arguments, size_t count) {
    fc_context &context = fc::context_of(ctx);
    fc_model found;
    fc::Text why;
    if (fc::read_value_model(model, {arguments, count}, nullptr, &found, &why) != FC_OK)
        return fc::add_probe_fault(context, id, {}, FC_E_ARG, why.c_str());
    return fc::add_model(context, id, found);
}

fc_fault_id fc_channel_arm_named(fc_context *ctx, const char *channel, const char *model,
                                 const fc_argument *arguments, size_t count) {
    try {
        return fc::arm_channel_model(ctx, channel, model, arguments, count);
    } catch (const std::bad_alloc &) {
        return fc::add_channel_fault(fc::context_of(ctx), channel, {}, FC_E_NOMEM, "out of memory");
    }
}

} // extern "C"
