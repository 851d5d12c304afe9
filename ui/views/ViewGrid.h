// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/measure/BoxWindow.h"
#include "ui/views/FrameInbox.h"
#include "ui/views/PlaneView.h"
#include "ui/views/SliceView.h"
#include "ui/views/VolumeView.h"

#include <QPointer>
#include <QWidget>

#include <array>
#include <functional>
#include <memory>

namespace ui {

/// The linked views in their layouts. Four: axial and 3D above, sagittal and coronal below. Pen and
/// stage (seed B §3): the cutting plane beside the 3D view. Or one of them alone. In any layout the
/// pen view can be in a window of its own, on another screen.
class ViewGrid : public QWidget {
    Q_OBJECT

public:
    explicit ViewGrid(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] SliceView& axial() const { return *m_axial; }
    [[nodiscard]] SliceView& sagittal() const { return *m_sagittal; }
    [[nodiscard]] SliceView& coronal() const { return *m_coronal; }
    [[nodiscard]] VolumeView& volume() const { return *m_volume; }
    [[nodiscard]] PlaneView& plane() const { return *m_plane; }
    [[nodiscard]] std::array<ImageView*, 5> views() const;
    [[nodiscard]] std::array<SliceView*, 4> slices() const; ///< all but the 3D view
    /// How axial, sagittal and coronal slices lie.
    [[nodiscard]] MprPlanes& planes() { return m_planes; }
    [[nodiscard]] const MprPlanes& planes() const { return m_planes; }
    /// The view that has the keyboard, or had it last.
    [[nodiscard]] ImageView& current() const { return *m_current; }

    enum class Layout { Four, PenAndStage };
    [[nodiscard]] Layout arrangement() const { return m_layout; }
    /// Shows the views of a layout and maximises none. Pen and stage also switches the cutting
    /// plane on.
    void arrange(Layout layout);
    /// Shows one view alone; null shows those of the layout again.
    void maximise(ImageView* view);
    [[nodiscard]] ImageView* maximised() const { return m_maximised; }
    /// Moves the pen view to a window of its own, or back to the grid.
    void setPenApart(bool apart);
    [[nodiscard]] bool isPenApart() const { return m_penWindow != nullptr; }
    /// Texts of the views keep below a widget that lies over them, while it is shown.
    void keepClearOf(QWidget& over);
    void resetViews();
    /// Adds a function that appends entries to the end of the context menus of all views.
    void addToMenus(const std::function<void(QMenu&)>& more);
    /// Sets whether the next drag of the left button on a slice draws the box that sets the window.
    /// With Ctrl the right button draws one at any time.
    void awaitBox(bool awaits);
    [[nodiscard]] bool awaitsBox() const { return m_axial->awaitsBox(); }
    /// Whether the values in a box are being read.
    [[nodiscard]] bool readsBox() const { return m_boxWindow.busy(); }
    /// Shows a slice of a study that is being loaded, until one is open; null ends that.
    /// @return whether the plane of any view is that slice; the other views have nothing to show
    /// yet
    bool showEarlySlice(const std::shared_ptr<const core::EarlySlice>& early);
    [[nodiscard]] const core::EarlySlice* earlySlice() const { return m_early.get(); }
    /// Keeps the pictures that are on the screen until those of the study that is opened next
    /// arrive; see ImageView::holdPicture().
    void holdPictures(const QString& awaited);
    /// Ends that: nothing is opened after all.
    void releasePictures();
    [[nodiscard]] bool holdsPictures() const;
    /// Whether every visible view shows the finest picture of its scene.
    [[nodiscard]] bool refined() const;

Q_SIGNALS:
    void layoutChanged();
    void awaitsBoxChanged();
    void picturesReleased();
    void pictureChanged(); ///< some view's quality changed
    void frameTimed(double milliseconds);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void give(const gpu::Frame& frame);
    /// Where places are linked, the other slices follow the one that was zoomed or panned.
    void leadBy(const SliceView& leader);
    void centreOn(const glm::dvec3& placeLps);
    void place();
    void placeTexts();

    Workspace& m_workspace;

    FrameInbox m_inbox;
    BoxWindow m_boxWindow;
    MprPlanes m_planes;
    std::shared_ptr<const core::EarlySlice> m_early;
    SliceView* m_axial;
    VolumeView* m_volume;
    SliceView* m_sagittal;
    SliceView* m_coronal;
    PlaneView* m_plane;
    QPointer<QWidget> m_over; ///< what texts keep clear of
    QWidget* m_penWindow = nullptr; ///< the window of the pen view; null: it is in the grid
    ImageView* m_current;
    ImageView* m_maximised = nullptr;
    Layout m_layout = Layout::Four;
};

} // namespace ui
