// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace ui {

/// Small words that wrap.
[[nodiscard]] QLabel* smallText(const QString& text, QWidget* parent);

/// Small words in the secondary colour, on one line: what stands beside something else.
[[nodiscard]] QLabel* smallNote(
    const QString& text, QWidget* parent, Qt::Alignment side = Qt::AlignLeft);

} // namespace ui
