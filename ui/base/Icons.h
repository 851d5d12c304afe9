// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

namespace ui {

/// Makes the program's icons and style known; a static library's resources are not found otherwise.
void registerResources();

/// One of resources/icons (name without ".svg"), drawn in one colour at @p size logical pixels.
[[nodiscard]] QPixmap tintedIcon(
    const QString& name, const QColor& colour, int size, double devicePixelRatio);

/// The icon in its states: secondary text colour at rest, text colour when pointed at, accent when
/// on, faint when disabled.
[[nodiscard]] QIcon stateIcon(const QString& name);

} // namespace ui
