// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QPushButton;
class QWidget;

namespace ui {

/// A button like those of a media player, with a picture and a word.
[[nodiscard]] QPushButton* transportButton(
    QWidget* parent, const QString& name, const QString& icon, const QString& text);
/// A button with a word only, where there is little room.
[[nodiscard]] QPushButton* narrowButton(QWidget* parent, const QString& name, const QString& text);

} // namespace ui
