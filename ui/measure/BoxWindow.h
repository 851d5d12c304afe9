// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/measure/RegionReader.h"

namespace ui {

class Workspace;

/// Sets the grey scale of slices from the values in a box on one of them, beside the window
/// (RegionReader): what is darker than all but 2 % of the box is black, what is brighter than 98 %
/// is white, so that a few extreme voxels decide nothing.
class BoxWindow : public QObject {
    Q_OBJECT

public:
    static constexpr int blackPercent = 2;
    static constexpr int whitePercent = 98;

    explicit BoxWindow(Workspace& workspace, QObject* parent = nullptr);

    /// @param box a region in a plane; the one before, if it is still being read, is dropped
    void setFrom(const core::Measurement& box);
    [[nodiscard]] bool busy() const { return m_reader.busy(); }

private:
    void take(const RegionReader::Found& found);

    Workspace& m_workspace;
    RegionReader m_reader;
};

} // namespace ui
