// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

namespace ui {

/// Registers the program's icons and style sheet. Without this call the resources of a static
/// library are not found.
void registerResources();

/// One of resources/icons (name without ".svg"), drawn in one colour at @p size logical pixels.
[[nodiscard]] QPixmap tintedIcon(
    const QString& name, const QColor& colour, int size, double devicePixelRatio);

/// An icon with its states: secondary text colour at rest, text colour under the pointer, accent
/// colour when on, faint when disabled.
[[nodiscard]] QIcon stateIcon(const QString& name);

} // namespace ui
