// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace ui {

/// The sentence of a dialog that says how things stand; plain text, in as many lines as it needs.
class StateLine : public QLabel {
    Q_OBJECT

public:
    explicit StateLine(const QString& name, QWidget* parent = nullptr);

    /// In place of the last one. @param role of the style: "secondary", "good", "caution", "bad"
    void say(const QString& sentence, const char* role = "secondary");
};

} // namespace ui
