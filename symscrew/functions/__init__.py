"""The functions of a model, by subject: each module turns a `System` into `Function`s."""
