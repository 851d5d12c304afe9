// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/dicomweb/MultipartReader.h"
#include "core/dicomweb/WebConnection.h"
#include "core/pacs/retrieve/DownloadFolder.h"

#include <QFile>
#include <QSet>

#include <memory>
#include <optional>

namespace core {

/// Stores the objects of a WADO-RS answer in a folder, one at a time. Objects that are damaged or
/// were not requested are dropped.
class WebIntake : public WebSink, private PartSink {
public:
    /// @param awaited SOP instance UIDs
    /// @param takesAll whether other objects are taken too, since not all of them are known
    WebIntake(const DownloadFolder& folder, const QSet<QString>& awaited, bool takesAll,
        QString nodeName, const Progress& progress);
    ~WebIntake() override;

    [[nodiscard]] Result<void> begin(const WebAnswer& answer) override;
    [[nodiscard]] Result<void> take(const QByteArray& bytes) override;
    [[nodiscard]] int wholeParts() const override { return m_accepted + m_unasked; }
    /// To be called after the last byte of an answer. NodeLost: the answer was incomplete.
    [[nodiscard]] Result<void> end();

    [[nodiscard]] int received() const { return int(m_received.size()); }
    /// How many objects were accepted, those included that came again.
    [[nodiscard]] int accepted() const { return m_accepted; }
    [[nodiscard]] const QSet<QString>& missing() const { return m_missing; }
    /// Why the first damaged object was dropped.
    [[nodiscard]] const std::optional<Error>& refusal() const { return m_refusal; }

private:
    [[nodiscard]] Result<void> beginPart() override;
    [[nodiscard]] Result<void> takePart(const char* bytes, qsizetype size) override;
    [[nodiscard]] Result<void> endPart() override;
    void dropPart();

    const DownloadFolder& m_folder;
    bool m_takesAll;
    QSet<QString> m_missing;
    qsizetype m_total; ///< 0: unknown
    QString m_nodeName;
    const Progress& m_progress;
    std::optional<MultipartReader> m_reader; ///< none: the answer is a single object
    QFile m_part;
    QSet<QString> m_received;
    int m_accepted = 0;
    int m_unasked = 0;
    std::optional<Error> m_refusal;
};

} // namespace core
