// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QPushButton;
class QWidget;

namespace ui {

/// A button with an icon and a word, like those of a media player.
[[nodiscard]] QPushButton* transportButton(
    QWidget* parent, const QString& name, const QString& icon, const QString& text);
/// A button with a word only, for narrow rows.
[[nodiscard]] QPushButton* narrowButton(QWidget* parent, const QString& name, const QString& text);

} // namespace ui
