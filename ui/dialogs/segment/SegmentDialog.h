// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QVBoxLayout;

namespace core {
struct Segment;
}

namespace ui {

class FittingLabel;
class Workspace;

/// A dialog about a segment, whose name stands at the top. It stays open beside the window, whose
/// keys work in it, too, and is closed when another study is there.
class SegmentDialog : public QDialog {
    Q_OBJECT

public:
    /// @param name with which its widgets are found: "split" for "splitWhose", the segment's name
    SegmentDialog(Workspace& workspace, const QString& title, const QString& name, QWidget* parent);

protected:
    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// What it is about; ask() of a dialog sets it.
    [[nodiscard]] int label() const { return m_label; }
    void setLabel(int label) { m_label = label; }
    /// Null: there is none, or not any more.
    [[nodiscard]] const core::Segment* segment() const;
    /// Below the name, from above.
    [[nodiscard]] QVBoxLayout& column() const { return *m_column; }
    /// Shows it in front of the window, ready for keys.
    void bringUp();
    /// Shows how the segment is now; at first, its name.
    virtual void showState();

private:
    Workspace& m_workspace;
    int m_label = 0;
    FittingLabel* m_whose;
    QVBoxLayout* m_column;
};

} // namespace ui
