// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace ui {

/// A label in small type that wraps.
[[nodiscard]] QLabel* smallText(const QString& text, QWidget* parent);

/// A label in small type and the secondary colour, on one line, for notes beside other things.
[[nodiscard]] QLabel* smallNote(
    const QString& text, QWidget* parent, Qt::Alignment side = Qt::AlignLeft);

} // namespace ui
