// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SegSettings.h"
#include "core/document/Document.h"

#include <QTreeWidget>

#include <bitset>
#include <map>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

class Workspace;

/// The segments of the session with millilitres, codes and remarks, each with a tick: those that
/// are exported.
class ExportSegments : public QTreeWidget {
    Q_OBJECT

public:
    explicit ExportSegments(Workspace& workspace, QWidget* parent = nullptr);

    /// Those that are ticked, in the order of the list.
    [[nodiscard]] std::vector<core::Segment> chosen() const;
    /// What was said of them beside their type, by label; for this export.
    [[nodiscard]] const std::map<int, core::SegCodes>& codes() const { return m_codes; }
    void fill();
    /// Those with voxels, or none.
    void tickAll(bool ticked);

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    void addRow(const core::Segment& segment, const QStringList& remarks);
    void chooseCode(QTreeWidgetItem* item);

    Workspace& m_workspace;
    std::bitset<256> m_unticked; ///< labels the user took the tick from, or that began without
    std::map<int, core::SegCodes> m_codes;
    bool m_filling = false;
};

/// Segments whose growth may go on: it was seeded and has not been told to be at closure.
[[nodiscard]] std::bitset<256> growingLabels(core::EditSession& session);

} // namespace ui
