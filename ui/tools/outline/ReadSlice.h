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

/// Reads the values of the slice in which an outline follows the picture. The engine reads them;
/// for an oblique slice a background thread chooses the voxels and puts the values in order. The
/// window waits for neither. GUI thread.
class ReadSlice : public QObject {
    Q_OBJECT

public:
    explicit ReadSlice(Workspace& workspace, QObject* parent = nullptr);

    /// Starts to read the slice that a view shows, unless it is the present one. Another slice is
    /// dropped.
    void look(const ViewContext& view);
    /// Drops the slice. To be called when another session is opened.
    void drop();

    /// The pixels of the present slice in space. Empty if there is none or if it misses the volume.
    [[nodiscard]] const core::SliceLattice& lattice() const { return m_lattice; }
    /// The values of its pixels; null until they are read.
    [[nodiscard]] const std::shared_ptr<const core::SlicePixels>& pixels() const
    {
        return m_pixels;
    }

Q_SIGNALS:
    void dropped(); ///< the slice was dropped, or is about to be another one
    void arrived(); ///< its values have been read

private:
    struct Portions;
    void readBox();
    void chooseVoxels();
    /// Asks for the next portion. Only one portion at a time waits in the engine, since the slice
    /// may be left at any moment.
    void readOn(const std::shared_ptr<Portions>& portions);
    void putInOrder(const std::shared_ptr<Portions>& portions);
    void take(std::shared_ptr<const core::SlicePixels> pixels);
    /// Drops the slice, so that the next look() reads it again.
    void fail(const core::Error& error);

    Workspace& m_workspace;
    core::SliceLattice m_lattice;
    std::shared_ptr<const core::SlicePixels> m_pixels;
    std::uint64_t m_asked = 0; ///< number of slices so far; answers about earlier ones are ignored
    core::Background m_background;
};

} // namespace ui
