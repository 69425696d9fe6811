#ifndef QUADRILLE_INTERNAL_CORE_POLICY_RECORDER_HANDLE_H
#define QUADRILLE_INTERNAL_CORE_POLICY_RECORDER_HANDLE_H

#include <quadrille/recorded.h>
#include <quadrille/report.h>

#include <utility>

namespace quadrille::internal {

/// A recorder of any type that the user keeps, told at run time.
class RecorderHandle {
public:
  template <class R>
  explicit RecorderHandle(R& recorder) : recorder_(&recorder) {
    begin_ = [](void* r, RecordedSurface&& surface) {
      static_cast<R*>(r)->begin(std::move(surface));
    };
    record_ = [](void* r, const RecordedContraction& contraction) {
      static_cast<R*>(r)->record(contraction);
    };
    if constexpr (requires(const RecordedRefusal& refusal) { recorder.refuse(refusal); })
      refuse_ = [](void* r, const RecordedRefusal& refusal) {
        static_cast<R*>(r)->refuse(refusal);
      };
    end_ = [](void* r, StopReason reason) {
      if constexpr (requires { static_cast<R*>(r)->stop(reason); })
        static_cast<R*>(r)->stop(reason);
      static_cast<R*>(r)->end();
    };
  }

  bool hears_refusals() const { return refuse_ != nullptr; }

  void begin(RecordedSurface surface) const { begin_(recorder_, std::move(surface)); }
  void record(const RecordedContraction& contraction) const { record_(recorder_, contraction); }
  void refuse(const RecordedRefusal& refusal) const { refuse_(recorder_, refusal); }
  void end(StopReason reason) const { end_(recorder_, reason); }

private:
  void* recorder_;
  void (*begin_)(void*, RecordedSurface&&) = nullptr;
  void (*record_)(void*, const RecordedContraction&) = nullptr;
  void (*refuse_)(void*, const RecordedRefusal&) = nullptr;
  void (*end_)(void*, StopReason) = nullptr;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_RECORDER_HANDLE_H
