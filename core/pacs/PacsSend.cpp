// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsSend.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/TransferSyntax.h"
#include "core/pacs/Association.h"
#include "core/pacs/NodeStatus.h"

#include <QFile>
#include <QFileInfo>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/dimse.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <utility>
#include <vector>

namespace core {

namespace {

/// A file on its way, as its header says.
struct Parcel {
    QString path;
    QByteArray classUid;
    QByteArray instanceUid;
    QByteArray syntaxUid;

    [[nodiscard]] bool isPlain() const
    {
        const TransferSyntax& syntax = transferSyntax(QString::fromLatin1(syntaxUid));
        // DCMTK 3.6.7 may send deflated data without end: they are sent inflated.
        return syntax.coding == PixelCoding::Native;
    }
};

Result<Parcel> parcelOf(const QString& path)
{
    const Result<DicomFile> file = DicomFile::openWithPixels(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    if (file->pixelsCut())
        return failure(ErrorCode::FileTruncated, path);
    DcmDataset set;
    if (const Result<void> read = file->readInto(set); !read)
        return tl::unexpected<Error>(read.error());
    const auto uid = [&set](const DcmTagKey& tag) {
        OFString text;
        set.findAndGetOFString(tag, text);
        return QByteArray(text.c_str());
    };
    Parcel parcel{.path = path,
        .classUid = uid(DCM_SOPClassUID),
        .instanceUid = uid(DCM_SOPInstanceUID),
        .syntaxUid = file->transferSyntaxUid().toLatin1()};
    const auto isUid = [](const QByteArray& text) { return !text.isEmpty() && text.size() <= 64; };
    if (!isUid(parcel.classUid) || !isUid(parcel.instanceUid)) {
        return failure(
            ErrorCode::UnsupportedFormat, path, Clause::saying("it is no object of its own"));
    }
    return parcel;
}

std::vector<ProposedContext> contextsFor(const std::vector<Parcel>& parcels)
{
    std::set<std::pair<QByteArray, QByteArray>> pairs;
    for (const Parcel& parcel : parcels)
        pairs.emplace(parcel.classUid, parcel.isPlain() ? QByteArray() : parcel.syntaxUid);
    std::vector<ProposedContext> contexts;
    for (const auto& [classUid, packed] : pairs) {
        contexts.push_back(
            {classUid, packed.isEmpty() ? plainSyntaxes() : std::vector<QByteArray>{packed}});
    }
    constexpr std::size_t most = 128;
    if (contexts.size() > most)
        contexts.resize(most);
    return contexts;
}

Result<std::uint16_t> store(Association& association, const Parcel& parcel)
{
    const Result<std::uint8_t> context =
        association.context(parcel.classUid, parcel.isPlain() ? QByteArray() : parcel.syntaxUid);
    if (!context)
        return tl::unexpected<Error>(context.error());
    DcmFileFormat format;
    const OFCondition loaded = format.loadFile(QFile::encodeName(parcel.path).constData());
    if (loaded.bad()) {
        return failure(ErrorCode::FileUnreadable, parcel.path, QString::fromUtf8(loaded.text()));
    }
    T_DIMSE_C_StoreRQ request{};
    request.MessageID = association.nextMessageId();
    std::strcpy(request.AffectedSOPClassUID, parcel.classUid.constData());
    std::strcpy(request.AffectedSOPInstanceUID, parcel.instanceUid.constData());
    request.DataSetType = DIMSE_DATASET_PRESENT;
    request.Priority = DIMSE_PRIORITY_MEDIUM;
    T_DIMSE_C_StoreRSP response{};
    DcmDataset* detail = nullptr;
    const OFCondition stored = DIMSE_storeUser(association.get(), *context, &request, nullptr,
        format.getDataset(), nullptr, nullptr, DIMSE_NONBLOCKING, association.node().timeoutSeconds,
        &response, &detail);
    delete detail;
    if (stored.bad())
        return tl::unexpected<Error>(association.error(stored));
    association.notePassed();
    return response.DimseStatus;
}

} // namespace

Result<SentObjects> sendFiles(
    const PacsNode& node, const QStringList& files, const Progress& progress)
{
    std::vector<Parcel> parcels;
    for (const QString& path : files) {
        Result<Parcel> parcel = parcelOf(path);
        if (!parcel)
            return tl::unexpected<Error>(parcel.error());
        parcels.push_back(std::move(*parcel));
    }
    SentObjects result;
    if (parcels.empty())
        return result;
    Result<Association> association = Association::request(node, contextsFor(parcels), progress);
    if (!association)
        return tl::unexpected<Error>(association.error());
    for (const Parcel& parcel : parcels) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        const Result<std::uint16_t> status = store(*association, parcel);
        if (!status)
            return tl::unexpected<Error>(status.error());
        const QString name = QFileInfo(parcel.path).fileName();
        const bool isWarning = (*status >> 12) == 0xb;
        if (*status != 0 && !isWarning) {
            association->release();
            return failure(ErrorCode::NodeFailed, node.name(),
                Clause::saying("the storage of %1", name), statusText(*status));
        }
        if (isWarning)
            result.warnings.append(QStringLiteral("%1: %2").arg(name, statusText(*status)));
        ++result.sent;
        progress.report(ProgressStep::Sending, result.sent, int(parcels.size()));
    }
    association->release();
    return result;
}

} // namespace core
