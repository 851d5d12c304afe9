// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/outline/SliceLattice.h"
#include "core/outline/SlicePixels.h"
#include "ui/geometry/ViewContext.h"

#include <QObject>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ui {

class Workspace;

/// The values of the slice in which an outline follows the picture. The engine reads them, voxels
/// of an oblique slice are chosen and put in order on another thread, and the window waits for
/// neither.
class ReadSlice : public QObject {
    Q_OBJECT

public:
    explicit ReadSlice(Workspace& workspace, QObject* parent = nullptr);

    /// Has the slice that a view shows read, unless it is the one that it has. What is known of
    /// another one is dropped.
    void look(const ViewContext& view);
    /// To be called when the session is another one.
    void drop();

    /// Of the slice that was looked at last; empty if none was, or if it misses the volume.
    [[nodiscard]] const core::SliceLattice& lattice() const { return m_lattice; }
    /// Its values; null until they are read.
    [[nodiscard]] const std::shared_ptr<const core::SlicePixels>& pixels() const
    {
        return m_pixels;
    }

Q_SIGNALS:
    void dropped(); ///< the slice is another one
    void arrived(); ///< its values are read

private:
    struct Portions;
    void readBox();
    void chooseVoxels();
    /// The next portion. No more than one waits in the engine for a slice that may be left by then.
    void readOn(const std::shared_ptr<Portions>& portions);
    void putInOrder(const std::shared_ptr<Portions>& portions);
    void take(std::shared_ptr<const core::SlicePixels> pixels);
    /// Drops the slice, so that it is read again when it is looked at next.
    void fail(const core::Error& error);

    Workspace& m_workspace;
    core::SliceLattice m_lattice;
    std::shared_ptr<const core::SlicePixels> m_pixels;
    std::uint64_t m_asked = 0; ///< number of slices; only answers about the last one count
    core::Background m_background;
};

} // namespace ui
