// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SegSettings.h"
#include "core/document/Document.h"
#include "core/export/common/ExportChoices.h"

#include <QTreeWidget>

#include <bitset>
#include <map>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

class Workspace;

/// A list of the segments of the session with millilitres, codes and remarks; the ticked ones are
/// exported.
class ExportSegments : public QTreeWidget {
    Q_OBJECT

public:
    explicit ExportSegments(Workspace& workspace, QWidget* parent = nullptr);

    /// The ticked segments, in the order of the list.
    [[nodiscard]] std::vector<core::Segment> chosen() const;
    /// Further codes that were chosen for segments, by label; for this export only.
    [[nodiscard]] const std::map<int, core::SegCodes>& codes() const { return m_codes; }
    void fill();
    /// Ticks all segments that have voxels, or none.
    void tickAll(bool ticked);

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    void addRow(const core::ExportChoice& choice);
    void chooseCode(QTreeWidgetItem* item);

    Workspace& m_workspace;
    std::bitset<256> m_unticked; ///< labels whose tick the user removed, or that began without
    std::map<int, core::SegCodes> m_codes;
    bool m_filling = false;
};

/// The segments whose growth could go on: they were seeded, and no closure was reported.
[[nodiscard]] std::bitset<256> growingLabels(core::EditSession& session);

} // namespace ui
