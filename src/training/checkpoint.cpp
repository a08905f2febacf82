#include "training/checkpoint.hpp"

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "base/json_tree.hpp"
#include "base/safetensors.hpp"
#include "base/sha256.hpp"

namespace mien::training {

std::string fingerprint(const Halves& halves, const TrainingSettings& s) {
    Sha256 hash;
    const auto add = [&](const void* data, std::size_t size) { hash.update(data, size); };
    for (const auto& half : halves) {
        const std::string layers = layers_json(half->initial);
        add(layers.data(), layers.size());
        for (const auto& entry : half->initial.tensors)
            add(entry.second.data, static_cast<std::size_t>(entry.second.count()) * 4);
        add(half->training.input.data(), half->training.input.size() * sizeof(float));
        add(half->training.output.data(), half->training.output.size() * sizeof(float));
    }
    const double numbers[] = {
        static_cast<double>(s.batch), s.learning_rate, s.decay, s.weight_decay, s.divergence,
        static_cast<double>(s.seed)};
    add(numbers, sizeof numbers);
    if (halves.size() > 1) add(&s.conditioning, sizeof s.conditioning);
    if (s.frozen_encoder) add("frozen", 6);
    return hash.hex_digest();
}

void save_checkpoint(const std::string& path, const std::string& mark, const Halves& halves,
                     const TrainingResult& result, double best_loss) {
    std::vector<Tensor> kept;
    std::vector<TensorToWrite> tensors;
    const auto add = [&](const std::string& name, const Tensor& tensor) {
        kept.push_back(tensor.detach().to(torch::kCPU).contiguous());
        const auto sizes = kept.back().sizes();
        tensors.push_back({name, DType::f32, std::vector<std::uint64_t>(sizes.begin(), sizes.end()),
                           kept.back().data_ptr<float>()});
    };
    for (auto& half : halves)
        for (const auto& [name, weight] : half->model.weights()) {
            add(half->name + "weight." + name, weight);
            add(half->name + "first." + name, half->adam.first().at(name));
            add(half->name + "second." + name, half->adam.second().at(name));
            const NetworkTensor& best = half->best.tensors.at(name);
            tensors.push_back({half->name + "best." + name, best.dtype, best.shape, best.data});
        }
    JsonText json;
    json.begin_object().field("steps", halves[0]->adam.steps());
    json.field("best_epoch", result.best_epoch);
    json.field("best_loss", best_loss).key("epochs").begin_array();
    for (const EpochRecord& record : result.epochs)
        json.begin_array()
            .number(record.training_loss)
            .number(record.divergence)
            .number(record.validation_loss)
            .number(record.seconds)
            .number(record.high_training_loss)
            .number(record.high_validation_loss)
            .end_array();
    json.end_array().end_object();
    write_safetensors(path, tensors,
                      {{"kind", "mien-training-state"},
                       {"units", "none"},
                       {"fingerprint", mark},
                       {"state", json.take()}},
                      {});
}

void resume_checkpoint(const std::string& path, const std::string& mark, Halves& halves,
                       TrainingResult& result, double& best_loss) {
    const SafetensorsFile file = SafetensorsFile::open(path, {}, {});
    file.require_kind("mien-training-state");
    if (file.metadata("fingerprint") != mark)
        fail(Status::mismatch,
             "%.120s is of another network, other faces or other settings; remove it or choose "
             "another folder",
             path.c_str());
    const torch::NoGradGuard no_gradient;
    const auto read = [&](const std::string& name, Tensor to) {
        std::vector<std::int64_t> shape(to.sizes().begin(), to.sizes().end());
        const TensorView& view = file.tensor(name, DType::f32, shape);
        to.copy_(torch::from_blob(const_cast<void*>(view.data), to.sizes(),
                                  torch::TensorOptions().dtype(torch::kFloat32)));
    };
    const std::string& text = file.metadata("state");
    const JsonTree state(text.data(), text.size(), "the training state");
    for (auto& half : halves) {
        for (const auto& [name, weight] : half->model.weights()) {
            read(half->name + "weight." + name, weight);
            read(half->name + "first." + name, half->adam.first().at(name));
            read(half->name + "second." + name, half->adam.second().at(name));
            const TensorView& best = file.tensor(
                half->name + "best." + name, DType::f32,
                std::vector<std::int64_t>(weight.sizes().begin(), weight.sizes().end()));
            const auto* data = static_cast<const float*>(best.data);
            half->best.tensors[name] =
                make_tensor(best.shape, std::vector<float>(data, data + best.count));
        }
        half->model.write_to(half->last);
        half->adam.set_steps(static_cast<std::int64_t>(state.root()["steps"].count("steps")));
    }
    result.best_epoch = static_cast<int>(state.root()["best_epoch"].count("best_epoch"));
    best_loss = state.root()["best_loss"].number("best_loss");
    for (const JsonTree::Value& row : state.root()["epochs"].items()) {
        const std::vector<JsonTree::Value> numbers = row.items();
        if (numbers.size() != 6) fail(Status::bad_format, "%.120s: no epochs", path.c_str());
        EpochRecord record;
        record.epoch = static_cast<int>(result.epochs.size()) + 1;
        record.training_loss = numbers[0].number("a loss");
        record.divergence = numbers[1].number("a divergence");
        record.validation_loss = numbers[2].number("a loss");
        record.seconds = numbers[3].number("seconds");
        record.high_training_loss = numbers[4].number("a loss");
        record.high_validation_loss = numbers[5].number("a loss");
        result.epochs.push_back(record);
    }
}

}  // namespace mien::training
