// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

class QPainter;

namespace ui {

class Workspace;

/// At every shown piece that is not at home: its name, how far it was moved and turned, and its
/// factor, so that nobody takes it for where it is.
void paintPieceBadges(QPainter& painter, const ViewContext& view, const Workspace& workspace);

} // namespace ui
