// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/demo/DemoStudy.h"
#include "gpu/engine/GpuEngine.h"

#include <QString>

namespace bench {

/// frame.surface, frame.dvr, frame.mip: one full-resolution frame of 1230×870 of the demonstration
/// head, against VTK's GPU mapper and its fixed-point mapper with the same camera, threshold,
/// transfer function, window and sample distance.
/// @return why the pictures do not agree, and nothing is registered; empty: registered
QString registerFrames(gpu::GpuEngine& engine, const core::DemoStudy& study);

} // namespace bench
