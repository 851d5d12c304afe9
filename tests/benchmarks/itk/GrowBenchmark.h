// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/demo/DemoStudy.h"
#include "gpu/engine/GpuEngine.h"

#include <QString>

namespace bench {

class PeerReport;

/// grow.closure: soft tissue of the demonstration head from one seed to closure, against ITK's
/// ConnectedThreshold.
/// @return why the results are not equal, and nothing is registered; empty: registered
QString registerGrowth(gpu::GpuEngine& engine, const core::DemoStudy& study);

/// grow.ball and so on: shapes of 10 to 60 million voxels in 512 cubed, against the same;
/// grow.skull and so on: real series, where the shared data are.
/// @return why the results are not equal; empty: all is added
QString measureGrowth(PeerReport& report);

/// The study as Burin's codes: HU + 1024.
std::vector<std::uint16_t> demoCodes(const core::DemoStudy& study);

} // namespace bench
