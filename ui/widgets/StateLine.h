// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace ui {

/// The line of a dialog that states its present state in a sentence; plain text, in as many lines
/// as it needs.
class StateLine : public QLabel {
    Q_OBJECT

public:
    explicit StateLine(const QString& name, QWidget* parent = nullptr);

    /// Replaces the sentence.
    /// @param role of the style: "secondary", "good", "caution", "bad"
    void say(const QString& sentence, const char* role = "secondary");
};

} // namespace ui
