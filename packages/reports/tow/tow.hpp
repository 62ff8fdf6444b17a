#pragma once
#include "hawser/report/report_registry.hpp"

namespace hawser {

/// <tow>: positioning errors of a towed cable, the force at its tow point, its receivers.
void register_tow(ReportRegistry& registry);

}  // namespace hawser
