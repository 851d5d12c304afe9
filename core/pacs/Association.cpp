// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/Association.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/pacs/AssociationParts.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcostrma.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/dcmlayer.h>
#include <dcmtk/dcmnet/dimse.h>

#include <algorithm>
#include <mutex>

namespace core {

namespace {

constexpr long longestPdu = ASC_MAXIMUMPDUSIZE;

Clause rejectionText(const T_ASC_RejectParameters& rejection, const PacsNode& node)
{
    switch (rejection.reason) {
    case ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED:
        return Clause::saying("it is not called %1", node.aeTitle);
    case ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED:
        return Clause::saying("it does not know us as %1", node.ownAeTitle);
    case ASC_REASON_SP_PRES_TEMPORARYCONGESTION:
    case ASC_REASON_SP_PRES_LOCALLIMITEXCEEDED:
        return Clause::saying("it is busy");
    case ASC_REASON_SU_APPCONTEXTNAMENOTSUPPORTED:
    case ASC_REASON_SP_ACSE_PROTOCOLVERSIONNOTSUPPORTED:
        return Clause::saying("it speaks another version of DICOM");
    default:
        return Clause::saying("it gives no reason");
    }
}

/// DCMTK's sentence without its prefix.
QString shortText(const OFCondition& condition)
{
    const QString text = QString::fromUtf8(condition.text());
    return text.mid(text.lastIndexOf(QLatin1String(": ")) + 1).simplified();
}

/// A stream that hands on what is written to it.
class SinkConsumer final : public DcmConsumer {
public:
    explicit SinkConsumer(const Association::Sink& sink)
        : m_sink(sink)
    {
    }
    OFBool good() const override { return OFTrue; }
    OFCondition status() const override { return EC_Normal; }
    OFBool isFlushed() const override { return OFTrue; }
    offile_off_t avail() const override { return 1 << 30; }
    offile_off_t write(const void* bytes, offile_off_t size) override
    {
        m_sink(static_cast<const char*>(bytes), std::size_t(size));
        return size;
    }
    void flush() override { }

private:
    const Association::Sink& m_sink;
};

class SinkStream final : public DcmOutputStream {
public:
    explicit SinkStream(SinkConsumer& consumer)
        : DcmOutputStream(&consumer)
    {
    }
};

Result<void> addContexts(T_ASC_Parameters* parameters, const std::vector<ProposedContext>& contexts)
{
    int number = 1;
    for (const ProposedContext& context : contexts) {
        std::vector<const char*> syntaxes;
        syntaxes.reserve(context.transferSyntaxes.size());
        for (const QByteArray& syntax : context.transferSyntaxes)
            syntaxes.push_back(syntax.constData());
        const OFCondition added =
            ASC_addPresentationContext(parameters, T_ASC_PresentationContextID(number),
                context.abstractSyntax.constData(), syntaxes.data(), int(syntaxes.size()),
                context.nodeSends ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT);
        if (added.bad())
            return failure(ErrorCode::Internal, QString::fromUtf8(added.text()));
        number += 2;
    }
    return {};
}

} // namespace

std::vector<QByteArray> plainSyntaxes()
{
    return {UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax};
}

QString nameOfUid(const QByteArray& uid)
{
    return QString::fromLatin1(dcmFindNameOfUID(uid.constData(), uid.constData()));
}

Association::Parts::~Parts()
{
    if (association) {
        const bool answers = state->connected && !state->closed && !state->timedOut;
        if (!released && answers && !state->cancelled)
            ASC_abortAssociation(association);
        ASC_dropAssociation(association);
        ASC_destroyAssociation(&association);
    } else if (parameters) {
        ASC_destroyAssociationParameters(&parameters);
    }
    if (network)
        ASC_dropNetwork(&network);
}

Association::Association(std::unique_ptr<Parts> parts)
    : m_parts(std::move(parts))
{
}

Association::Association(Association&&) noexcept = default;
Association& Association::operator=(Association&&) noexcept = default;
Association::~Association() = default;

Result<Association> Association::request(const PacsNode& node,
    const std::vector<ProposedContext>& contexts, const Progress& progress, Patience::Seconds whole)
{
    if (const Result<void> sound = node.check(); !sound)
        return tl::unexpected<Error>(sound.error());
    readyDcmtk();
    auto parts = std::make_unique<Parts>();
    parts->node = node;
    parts->ownState.progress = &progress;
    parts->ownState.timeoutSeconds = node.timeoutSeconds;
    parts->ownState.wholeSeconds = whole;
    Result<std::unique_ptr<DcmTransportLayer>> layer = makeWatchedLayer(parts->ownState, node.tls);
    if (!layer)
        return tl::unexpected<Error>(layer.error());
    parts->layer = std::move(*layer);
    // Process-wide in DCMTK: no reverse look-ups, and how long a connection may take to come about.
    dcmDisableGethostbyaddr.set(OFTrue);
    constexpr int longestConnect = 10;
    dcmConnectionTimeout.set(std::min(node.timeoutSeconds, longestConnect));

    Association made(std::move(parts));
    Parts& own = *made.m_parts;
    OFCondition condition =
        ASC_initializeNetwork(NET_REQUESTOR, 0, node.timeoutSeconds, &own.network);
    if (condition.good())
        condition = ASC_setTransportLayer(own.network, own.layer.get(), 0);
    if (condition.good())
        condition = ASC_createAssociationParameters(&own.parameters, longestPdu);
    if (condition.good())
        condition = ASC_setTransportLayerType(own.parameters, node.tls.wanted());
    if (condition.good()) {
        condition = ASC_setAPTitles(own.parameters, node.ownAeTitle.toLatin1().constData(),
            node.aeTitle.toLatin1().constData(), nullptr);
    }
    if (condition.good()) {
        const QByteArray peer = (node.host + u':' + QString::number(node.port)).toUtf8();
        condition = ASC_setPresentationAddresses(
            own.parameters, OFStandard::getHostName().c_str(), peer.constData());
    }
    if (condition.bad())
        return failure(ErrorCode::Internal, QString::fromUtf8(condition.text()));
    if (const Result<void> added = addContexts(own.parameters, contexts); !added)
        return tl::unexpected<Error>(added.error());
    condition = ASC_requestAssociation(own.network, own.parameters, &own.association, nullptr,
        nullptr, DUL_NOBLOCK, node.timeoutSeconds);
    if (condition == DUL_ASSOCIATIONREJECTED) {
        T_ASC_RejectParameters rejection{};
        ASC_getRejectParameters(own.parameters, &rejection);
        own.released = true;
        return failure(ErrorCode::NodeRejects, node.name(), rejectionText(rejection, node));
    }
    if (condition.bad()) {
        own.released = true;
        return tl::unexpected<Error>(made.error(condition));
    }
    made.notePassed();
    if (ASC_countAcceptedPresentationContexts(own.parameters) == 0) {
        made.release();
        return failure(
            ErrorCode::NodeRefuses, node.name(), nameOfUid(contexts.front().abstractSyntax));
    }
    return made;
}

T_ASC_Association* Association::get() const
{
    return m_parts ? m_parts->association : nullptr;
}

const PacsNode& Association::node() const
{
    return m_parts->node;
}

Result<std::uint8_t> Association::context(
    const QByteArray& abstractSyntax, const QByteArray& transferSyntax) const
{
    const T_ASC_PresentationContextID number = transferSyntax.isEmpty()
        ? ASC_findAcceptedPresentationContextID(get(), abstractSyntax.constData())
        : ASC_findAcceptedPresentationContextID(
            get(), abstractSyntax.constData(), transferSyntax.constData());
    if (number == 0) {
        return failure(ErrorCode::NodeRefuses, node().name(), nameOfUid(abstractSyntax));
    }
    return number;
}

QByteArray Association::transferSyntax(std::uint8_t context) const
{
    T_ASC_PresentationContext found{};
    if (ASC_findAcceptedPresentationContext(get()->params, context, &found).bad())
        return {};
    return found.acceptedTransferSyntax;
}

std::uint16_t Association::nextMessageId()
{
    return get()->nextMsgID++;
}

Result<void> Association::send(std::uint8_t context, T_DIMSE_Message& message, DcmDataset* data)
{
    const OFCondition sent =
        DIMSE_sendMessageUsingMemoryData(get(), context, &message, nullptr, data, nullptr, nullptr);
    if (sent.bad())
        return tl::unexpected<Error>(error(sent));
    notePassed();
    return {};
}

Result<T_DIMSE_Message> Association::receive(std::uint8_t& context)
{
    T_DIMSE_Message message{};
    T_ASC_PresentationContextID number = 0;
    DcmDataset* detail = nullptr;
    const OFCondition received = DIMSE_receiveCommand(
        get(), DIMSE_NONBLOCKING, node().timeoutSeconds, &number, &message, &detail);
    delete detail;
    if (received.bad())
        return tl::unexpected<Error>(error(received));
    notePassed();
    context = number;
    return message;
}

Result<void> Association::receiveData(std::uint8_t context, const Sink& sink)
{
    SinkConsumer consumer(sink);
    SinkStream stream(consumer);
    T_ASC_PresentationContextID number = context;
    const OFCondition received = DIMSE_receiveDataSetInFile(
        get(), DIMSE_NONBLOCKING, node().timeoutSeconds, &number, &stream, nullptr, nullptr);
    if (received.bad())
        return tl::unexpected<Error>(error(received));
    notePassed();
    return {};
}

void Association::notePassed()
{
    if (m_parts->state->patience)
        m_parts->state->patience->whole();
}

void Association::release()
{
    if (!get() || m_parts->released)
        return;
    m_parts->released = true;
    if (!m_parts->state->closed && ASC_releaseAssociation(get()).bad())
        ASC_abortAssociation(get());
}

void Association::markReleased()
{
    m_parts->released = true;
}

Error Association::error(const OFCondition& condition) const
{
    const WireState& state = *m_parts->state;
    const QString name = node().name();
    if (state.cancelled)
        return {ErrorCode::Cancelled, {}};
    const bool outOfTime = state.timedOut || state.clockRanOut || condition == DIMSE_NODATAAVAILABLE
        || condition == DUL_READTIMEOUT;
    if (state.connected && outOfTime) {
        const bool told = state.patience && state.lost != Patience::Lost::No;
        return told ? state.patience->error(name, state.lost)
                    : Error{ErrorCode::NodeTimeout, {name, QString::number(node().timeoutSeconds)}};
    }
    if (!state.nonsense.isEmpty())
        return {ErrorCode::NodeNonsense, {name, state.nonsense}};
    if (!state.handshake.isEmpty()) {
        return {ErrorCode::NodeUnreachable,
            {name, Clause::saying("no secure connection (%1)", state.handshake)}};
    }
    if (!state.trouble.isEmpty())
        return {ErrorCode::NodeLost, {name, state.trouble}};
    if (!state.connected)
        return {ErrorCode::NodeUnreachable, {name, shortText(condition)}};
    if (state.closed || condition == DUL_NETWORKCLOSED || condition == DUL_PEERABORTEDASSOCIATION
        || condition == DUL_PEERREQUESTEDRELEASE)
        return {ErrorCode::NodeLost, {name}};
    return {ErrorCode::NodeNonsense, {name, shortText(condition)}};
}

} // namespace core
