// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QMenu;

namespace core {
struct CameraBookmark;
}

namespace ui {

class VolumeView;
class Workspace;

/// Views of the patient to come back to: keeps the 3D view and the crosshair by name, as a step of
/// undo, and lists what was kept. Going back to one is no step.
class BookmarkMenu : public QObject {
    Q_OBJECT

public:
    BookmarkMenu(Workspace& workspace, VolumeView& view, QObject* parent = nullptr);

    /// Asks for a name.
    void ask();
    void keep(const QString& name);
    void show(const core::CameraBookmark& bookmark);
    /// Fills the menu with what there is whenever it opens.
    void fill(QMenu& menu);

private:
    void list(QMenu& menu);
    [[nodiscard]] QString freeName() const;

    Workspace& m_workspace;
    VolumeView& m_view;
};

} // namespace ui
