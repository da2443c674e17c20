#include "axisc/answers/certify/certify_answer.hpp"

#include "axisc/answers/certify/certified_axis.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/environment/version.hpp"
#include "axisc/files/key_file.hpp"
#include "codegen/source_digest.hpp"
#include "image/signature.hpp"

namespace axisc::says {

constexpr Sentence title{"bounds of {image}", "Schranken von {image}"};
constexpr Sentence image{"image", "Abbild"};
constexpr Sentence sha{"SHA-256 {digest}", "SHA-256 {digest}"};
constexpr Sentence version_counter{"image version", "Abbildversion"};
constexpr Sentence signature{"signature", "Signatur"};
constexpr Sentence no_signature{"none", "keine"};
constexpr Sentence unchecked_key{"Ed25519, key {key} (not checked)",
                                 "Ed25519, Schlüssel {key} (nicht geprüft)"};
constexpr Sentence checked_by{"checked by", "geprüft von"};
constexpr Sentence verified{"Verified: {records} records.", "Bestätigt: {records} Datensätze."};
constexpr Sentence claims_nothing{
    "The image claims no bounds: these are computed, and nothing in the image vouches for them.",
    "Das Abbild behauptet keine Schranken: Diese sind gerechnet, und nichts im Abbild steht für sie ein."};
constexpr Sentence not_true{
    "Claims of this image that are NOT TRUE: {failures}; do not use it, compile it again.",
    "Aussagen dieses Abbilds, die NICHT WAHR sind: {failures}; nicht verwenden, neu kompilieren."};
constexpr Sentence not_covered{
    "Not covered: the drive, the design (see `axisc response`), setpoints beyond 2^53.",
    "Nicht abgedeckt: der Antrieb, der Entwurf (siehe `axisc response`), Sollwerte über 2^53."};
constexpr Sentence name_and_date{"Date, name, signature: ______________________________________________",
                                 "Datum, Name, Unterschrift: ___________________________________________"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// Only claims of the axes that are asked for are shown; those of all decide.
Words conclusion(image::CheckedBounds const& checked) {
  if (!checked.is_in_image) return says::claims_nothing;
  if (checked.failures() > 0) {
    return {says::not_true, {{"failures", exact(static_cast<double>(checked.failures()))}}};
  }
  return {says::verified, {{"records", exact(static_cast<double>(checked.records.size()))}}};
}

Facts head(CertifyQuestion const& question, ImageFile const& file, image::CheckedBounds const& checked) {
  auto const bytes = file.bytes.bytes();
  auto const digest =
      codegen::hexadecimal(codegen::sha256({reinterpret_cast<char const*>(bytes.data()), bytes.size()}));
  auto const signer = image::signer(bytes);
  Value const key = signer ? Value(key_name(*signer)) : Value();
  Words const signed_by =
      signer ? Words(says::unchecked_key, {{"key", key_name(*signer)}}) : Words(says::no_signature);
  return {{data("image", question.image),
           data("sha256", digest),
           shown(says::image, Words(says::sha, {{"digest", digest}})),
           {"image_version", says::version_counter, file.contents.image_version},
           data("signature_key", key),
           shown(says::signature, signed_by),
           data("compiler_version", file.contents.compiler_version),
           shown(labels::compiler, "axisc " + file.contents.compiler_version),
           data("checker_version", std::string(program_version())),
           shown(says::checked_by, "axisc " + std::string(program_version())),
           data("cycle_time_us", exact(file.contents.cycle_time.microseconds(), Unit::microsecond)),
           data("is_in_image", checked.is_in_image),
           data("verified", checked.is_in_image && checked.failures() == 0),
           data("record_count", exact(static_cast<double>(checked.records.size()))),
           data("failures", exact(static_cast<double>(checked.failures())))}};
}

}  // namespace

Document certify_answer(CertifyQuestion const& question, ImageFile const& file,
                        image::CheckedBounds const& checked) {
  Sections axes{.key = "axes", .items = {}};
  for (auto const axis : chosen_axes(file.contents, question.axis)) {
    axes.items.push_back(certified_axis(file.contents, axis, checked));
  }
  return {.version = 1,
          .title = Words(says::title, {{"image", question.image}}),
          .blocks = {head(question, file, checked), std::move(axes), Paragraph{conclusion(checked)},
                     Paragraph{says::not_covered}, Paragraph{says::name_and_date}},
          .csv_table = "records"};
}

}  // namespace axisc
