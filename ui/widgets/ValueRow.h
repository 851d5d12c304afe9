// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;

namespace ui {

/// A name at the left and its value at the right, one line, tabular figures.
class ValueRow : public QWidget {
    Q_OBJECT

public:
    explicit ValueRow(const QString& name, QWidget* parent = nullptr);

    void setValue(const QString& value);
    [[nodiscard]] QString value() const;

private:
    QLabel* m_value = nullptr;
};

} // namespace ui
