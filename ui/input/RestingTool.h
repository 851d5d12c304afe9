// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QString>

namespace ui {

class Tool;

/// Why a tool rests in a view in which it does not work (Tool::worksIn), and what brings it back,
/// as one sentence for the user who clicked there.
[[nodiscard]] QString whyToolRests(const Tool& tool, const ViewContext& view);

} // namespace ui
