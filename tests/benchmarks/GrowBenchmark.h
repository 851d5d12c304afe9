// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/demo/DemoStudy.h"
#include "gpu/GpuEngine.h"

#include <QString>

namespace bench {

/// grow.closure: soft tissue of the demonstration head from one seed to closure, against ITK's
/// ConnectedThreshold.
/// @return why the results are not equal, and nothing is registered; empty: registered
QString registerGrowth(gpu::GpuEngine& engine, const core::DemoStudy& study);

/// The study as Burin's codes: HU + 1024.
std::vector<std::uint16_t> demoCodes(const core::DemoStudy& study);

} // namespace bench
