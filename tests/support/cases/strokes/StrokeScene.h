// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/StrokeCases.h"

namespace test {

/// The volume that most cases are about, and the edits that several families of them share.
struct StrokeScene {
    core::Document document;
    core::LoadedVolume volume;
    core::Edit first;
    core::Edit second;
    core::Edit seeds;
    core::Edit others;
    core::Edit lock;
    core::GrowSteps some;
    core::GrowSteps all;
    core::GrowSteps none;
    core::GrowSteps over;
    core::DrillStroke drill;
    core::DrillStroke beside;
    core::DrillStroke drillBack;
    core::PaintStroke paint;
    core::PaintStroke eraser;
    core::PaintStroke slice;
    core::PaintStroke taker;
    core::BrushStroke brush;
    core::BrushStroke back;
    core::PeelCut peel;
    core::PeelCut peelBack;
};
[[nodiscard]] StrokeScene strokeScene();

[[nodiscard]] core::LoadedVolume loaded(const core::Document& document, const Codes& codes);
[[nodiscard]] core::AddSegment segmentNamed(const char* name);
[[nodiscard]] core::AddBookmark bookmarkOf(const core::DrillStroke& stroke);

} // namespace test
