// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "tests/support/cases/RandomEdits.h"
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
    core::Edit some;
    core::Edit all;
    core::Edit none;
    core::Edit over;
    core::Edit drill;
    core::Edit beside;
    core::Edit drillBack;
    core::Edit paint;
    core::Edit eraser;
    core::Edit slice;
    core::Edit taker;
    core::Edit brush;
    core::Edit back;
    core::Edit peel;
    core::Edit peelBack;
};
[[nodiscard]] StrokeScene strokeScene();

[[nodiscard]] core::LoadedVolume loaded(const core::Document& document, const Codes& codes);
[[nodiscard]] core::Edit segmentNamed(const char* name);
/// Of the view that a drill stroke was made in.
[[nodiscard]] core::Edit bookmarkOf(const core::Edit& drill);

} // namespace test
