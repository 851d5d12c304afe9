// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/measure/RegionReader.h"

namespace ui {

class Workspace;

/// Sets the window of slices from the values in a box on one of them: its lower end is the 2nd
/// percentile of the values, its upper end the 98th, so a few extreme voxels have no influence.
/// RegionReader reads the values in the background.
class BoxWindow : public QObject {
    Q_OBJECT

public:
    static constexpr int blackPercent = 2;
    static constexpr int whitePercent = 98;

    explicit BoxWindow(Workspace& workspace, QObject* parent = nullptr);

    /// Starts to read the box; the window changes when that is done. A box that is still being read
    /// is dropped.
    /// @param box a rectangle in a plane
    void setFrom(const core::Measurement& box);
    [[nodiscard]] bool busy() const { return m_reader.busy(); }

private:
    void take(const RegionReader::Found& found);

    Workspace& m_workspace;
    RegionReader m_reader;
};

} // namespace ui
