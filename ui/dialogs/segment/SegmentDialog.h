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

/// Base of the dialogs about one segment, with its name at the top. Such a dialog stays open beside
/// the window, and the window's keyboard shortcuts, undo above all, work in it, too. It closes when
/// another study is opened.
class SegmentDialog : public QDialog {
    Q_OBJECT

public:
    /// @param name prefix of the object names of its widgets: "split" gives "splitWhose" for the
    /// label with the segment's name
    SegmentDialog(Workspace& workspace, const QString& title, const QString& name, QWidget* parent);

protected:
    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// Label of the segment that the dialog is about. Derived dialogs set it when they are opened.
    [[nodiscard]] int label() const { return m_label; }
    void setLabel(int label) { m_label = label; }
    /// The segment; null if it does not exist or no session is open.
    [[nodiscard]] const core::Segment* segment() const;
    /// The layout below the segment's name, to which derived dialogs add their widgets.
    [[nodiscard]] QVBoxLayout& column() const { return *m_column; }
    /// Adds the button that says which voxels may change and lets the user choose them.
    void addEditable();
    /// Shows the dialog in front of the window and gives it the keyboard.
    void bringUp();
    /// Updates what is shown of the segment; the base shows its name.
    virtual void showState();

private:
    Workspace& m_workspace;
    int m_label = 0;
    FittingLabel* m_whose;
    QVBoxLayout* m_column;
};

} // namespace ui
