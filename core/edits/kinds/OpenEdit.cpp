// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/OpenEdit.h"

#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

const std::vector<PenSample>* samplesOf(const Edit& edit)
{
    if (const auto* drill = edit.as<DrillStroke>())
        return &drill->samples;
    const auto* laser = edit.as<LaserStroke>();
    return laser ? &laser->samples : nullptr;
}

std::vector<PenSample>* samplesOf(Edit& edit)
{
    return const_cast<std::vector<PenSample>*>(samplesOf(std::as_const(edit)));
}

std::optional<DrillPathSampler> samplerOf(const Edit& edit, const EngineEdit& begun)
{
    if (const auto* drill = edit.as<DrillStroke>())
        return DrillPathSampler(*drill, std::get<DrillCut>(begun));
    if (const auto* laser = edit.as<LaserStroke>())
        return DrillPathSampler(*laser, std::get<LaserCut>(begun));
    return std::nullopt;
}

bool* byTimeOf(Edit& edit)
{
    if (auto* drill = edit.as<DrillStroke>())
        return &drill->byTime;
    auto* laser = edit.as<LaserStroke>();
    return laser ? &laser->byTime : nullptr;
}

const BrushPath* brushPathOf(const Edit& edit)
{
    if (const auto* paint = edit.as<PaintStroke>())
        return &paint->path;
    if (const auto* barrier = edit.as<BarrierStroke>())
        return &barrier->path;
    const auto* brush = edit.as<BrushStroke>();
    return brush ? &brush->path : nullptr;
}

BrushPath* brushPathOf(Edit& edit)
{
    return const_cast<BrushPath*>(brushPathOf(std::as_const(edit)));
}

const std::optional<int>* growthStepsOf(const Edit& edit)
{
    if (const auto* grow = edit.as<GrowSteps>())
        return &grow->steps;
    const auto* change = edit.as<ChangeInterval>();
    return change ? &change->steps : nullptr;
}

std::optional<int>* growthStepsOf(Edit& edit)
{
    return const_cast<std::optional<int>*>(growthStepsOf(std::as_const(edit)));
}

} // namespace core
