#include "methods.hpp"

#include "certified.hpp"
#include "certified_batch.hpp"
#include "closed_form.hpp"
#include "decision_alone.hpp"
#include "four_triangles.hpp"
#include "newton.hpp"
#include "two_triangles.hpp"

namespace gapcheck::bench {
namespace {

template <class Number, class Way>
void run(const Pairs& pairs, std::span<Answer<double>> answers) {
  const auto& input = [&]() -> const auto& {
    if constexpr (std::is_same_v<Number, float>) {
      return pairs.in_float;
    } else {
      return pairs.in_double;
    }
  }
  ();
  for (std::size_t i = 0; i < input.size(); ++i) {
    const Answer<Number> answer = Way::answer(input[i]);
    answers[i] = {static_cast<double>(answer.distance), answer.closer};
  }
}

/// A plain method, in both precisions.
template <template <class> class Way>
void add(std::vector<Method>& list) {
  list.push_back({Way<float>::name(), "float", Distances::all, run<float, Way<float>>});
  list.push_back({Way<double>::name(), "double", Distances::all, run<double, Way<double>>});
}

template <int steps>
void add_newton(std::vector<Method>& list) {
  list.push_back({Newton<float, steps>::name(), "float", Distances::all, run<float, Newton<float, steps>>});
  list.push_back({Newton<double, steps>::name(), "double", Distances::all, run<double, Newton<double, steps>>});
}

std::vector<Method> make_methods() {
  std::vector<Method> list;
  add<TwoTriangles>(list);
  add<FourTriangles>(list);
  add<ClosedForm>(list);
  add_newton<1>(list);
  add_newton<2>(list);
  add_newton<3>(list);
  add_newton<4>(list);
  add_newton<5>(list);
  add_newton<6>(list);
  list.push_back({Certified::name(), "double", Distances::all, run<double, Certified>});
  list.push_back({CertifiedBatch::name(), "double", Distances::nearer, CertifiedBatch::run});
  list.push_back({DecisionAlone::name(), "double", Distances::none, run<double, DecisionAlone>});
  return list;
}

}  // namespace

void Pairs::add(const ContactPair<double>& pair) {
  ContactPair<float> rounded;
  for (std::size_t i = 0; i < 4; ++i) rounded.x[i] = pair.x[i].cast<float>();
  rounded.query = pair.query.cast<float>();
  rounded.bound = static_cast<float>(pair.bound);
  rounded.triangle = pair.triangle;
  in_double.push_back(pair);
  in_float.push_back(rounded);
}

const std::vector<Method>& methods() {
  static const std::vector<Method> list = make_methods();
  return list;
}

}  // namespace gapcheck::bench
